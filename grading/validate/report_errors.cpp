#include "grading/validate/rate.h"
#include "grading/validate/report.h"
#include <fmt/core.h>
#include <map>

namespace grading {
namespace {

    void printRate(const char* what, std::size_t count, std::size_t total, const char* of)
    {
        fmt::print("{:<48} {} of {} {}", what, count, total, of);
        if (total > 0)
            fmt::print(", at most {:.2f} %", 100.0 * upperBoundOfRate(count, total));
        fmt::print("\n");
    }

    // Each check of a solution once, with the first seed, however many seeds failed it.
    void printFailures(const std::vector<WrongFailure>& failures)
    {
        std::map<std::pair<std::string, std::string>, std::size_t> counts;
        for (const WrongFailure& failure : failures)
            ++counts[{ failure.solution, failure.check }];
        for (const WrongFailure& failure : failures) {
            const auto count = counts.extract({ failure.solution, failure.check });
            if (count.empty())
                continue;
            const std::string others = count.mapped() > 1 ? fmt::format(" and {} more", count.mapped() - 1) : "";
            const std::string firstLine = failure.message.substr(0, failure.message.find('\n'));
            fmt::print("  {}, seed {}{}: {}: {}\n", failure.solution, failure.seed, others, failure.check, firstLine);
        }
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
