#include "report/figures/seen_change.h"
#include <fmt/format.h>

namespace report {

SeenChange seenChange(const Stage& stage, const Picture& before, const Picture& after,
    const std::function<bool(const HitInfo&)>& isAllowed)
{
    const auto hits = stage.hits();
    SeenChange change { .pixels = hits.size() };
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const bool allowed = hits[i] && isAllowed(*hits[i]);
        change.allowed += allowed;
        if (before.pixels.at(i) != after.pixels.at(i))
            ++(allowed ? change.within : change.elsewhere);
    }
    return change;
}

Claim claimOf(const SeenChange& change, const std::string& about)
{
    const auto percent = [](std::size_t part, std::size_t whole) {
        return 100.0 * static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(whole, 1));
    };
    return {
        fmt::format("{0} fill {1:.1f} % of the picture; {2:.1f} % of their pixels change, and {3} pixels elsewhere.",
            about, percent(change.allowed, change.pixels), percent(change.within, change.allowed), change.elsewhere),
        change.within > 0 && change.elsewhere == 0
    };
}

}
