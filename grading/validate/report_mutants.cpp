#include "grading/validate/report.h"
#include <algorithm>
#include <fmt/core.h>

namespace grading {

void printMutants(const std::string& file, const std::vector<GradedMutant>& mutants)
{
    const auto count = [&](Fate fate) { return std::ranges::count(mutants, fate, &GradedMutant::fate); };
    fmt::print("{:<12} {:>4} mutants: {:>4} killed, {:>3} survived, {:>3} explained, {:>3} stillborn, {:>3} the same "
               "program\n",
        file, mutants.size(), count(Fate::Killed), count(Fate::Survived), count(Fate::Explained),
        count(Fate::Stillborn), count(Fate::Same));
    for (const GradedMutant& graded : mutants)
        if (graded.fate == Fate::Survived)
            fmt::print("reference/{}.cpp:{}: survived\n  - {}\n  + {}\n", file, graded.mutant.line,
                graded.mutant.original, graded.mutant.changed);
    std::fflush(stdout); // the next file may take minutes
}

}
