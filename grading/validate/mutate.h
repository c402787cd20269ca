#pragma once
#include "grading/grade.h"
#include "grading/validate/mutant.h"
#include "grading/validate/on_progress.h"

namespace grading {

enum class Fate {
    Stillborn, // does not compile
    Same, // compiles to the same object as the original
    Explained, // stands in the list of survivors
    Killed, // loses points
    Survived, // loses none: a hole in the checks, or as right as the original
};

struct GradedMutant {
    Mutant mutant;
    Fate fate;
};

// Grades all mutants of reference/<file>.cpp on the features of that file, in the order of mutantsOf().
// survivors: the list. Throws files::Error if that is bad, and
// std::runtime_error if the grader fails or the reference itself loses points.
[[nodiscard]] std::vector<GradedMutant> gradeMutants(const std::string& file,
    const std::shared_ptr<ExpectedAnswers>& expected, const std::filesystem::path& survivors,
    const OnProgress& onProgress);

}
