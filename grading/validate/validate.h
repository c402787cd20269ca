#pragma once
#include "grading/grade.h"
#include "grading/validate/bank.h"
#include "grading/validate/on_progress.h"

namespace grading {

// A check that failed and should not have.
struct WrongFailure {
    std::string solution;
    uint64_t seed;
    std::string check, message;
};

// What became of a bank.
struct GraderErrors {
    std::size_t wrongSolutions = 0;
    std::vector<std::string> falseAccepts; // wrong solutions for which a feature got all points that should not have
    std::size_t acceptedSolutions = 0, acceptedGradings = 0, falselyRejectedGradings = 0;
    std::vector<WrongFailure> falseRejects; // points that accepted solutions lost
    std::size_t untouchedFeatures = 0, wronglyTouchedFeatures = 0; // of wrong solutions, those that were right
    std::vector<WrongFailure> takenElsewhere; // points that these lost

    [[nodiscard]] bool none() const { return falseAccepts.empty() && falseRejects.empty() && takenElsewhere.empty(); }
};

// Grades every wrong solution once, and the accepted ones with as many seeds, counted from the first, as it takes for
// so many gradings; each of them the same number of times, rounded up. Throws what grade() does.
[[nodiscard]] GraderErrors validate(const Bank& bank, std::size_t acceptedGradings, uint64_t firstSeed,
    const std::shared_ptr<ExpectedAnswers>& expected, const OnProgress& onProgress);

}
