#include "app/explain.h"
#include <fmt/core.h>

namespace app {

void explain(const worker::Explanation& explanation)
{
    fmt::print("{}\n", worker::titleOfNeeds(explanation.skips));
    for (const auto& [what, value] : worker::linesOf(explanation.parts))
        fmt::print("  {:<32} {}\n", what, value);
    fmt::print("done\n");
    for (const auto& [what, value] : worker::linesOfWork(explanation))
        fmt::print("  {:<32} {:>12}\n", what, value);
}

}
