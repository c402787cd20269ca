#include "grading/validate/rate.h"
#include "grading/validate/report.h"
#include <fmt/core.h>

namespace grading {
namespace {

    void printRate(const char* what, std::size_t count, std::size_t total, const char* of)
    {
        fmt::print("{:<46} {} of {} {}", what, count, total, of);
        if (total > 0)
            fmt::print(", at most {:.2f} %", 100.0 * upperBoundOfRate(count, total));
        fmt::print("\n");
    }

    void printFailures(const std::vector<WrongFailure>& failures)
    {
        for (const WrongFailure& failure : failures)
            fmt::print("  {}, seed {}: {}: {}\n", failure.solution, failure.seed, failure.check, failure.message);
    }

}

void printErrors(const GraderErrors& errors)
{
    printRate("wrong solutions accepted", errors.falseAccepts.size(), errors.wrongSolutions, "wrong solutions");
    for (const std::string& solution : errors.falseAccepts)
        fmt::print("  {}\n", solution);
    printRate("right solutions rejected", errors.falselyRejectedGradings, errors.acceptedGradings,
        fmt::format("gradings of {} right solutions", errors.acceptedSolutions).c_str());
    printFailures(errors.falseRejects);
    printRate("features that lost points for another's mistake", errors.wronglyTouchedFeatures,
        errors.untouchedFeatures, "right features of wrong solutions");
    printFailures(errors.takenElsewhere);
    fmt::print("At most: 95 % upper bound of the rate, one-sided, Clopper and Pearson; 1 - 0.05^(1/n) for 0 of n.\n");
}

}
