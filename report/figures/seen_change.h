#pragma once
#include "report/figures/stage.h"
#include "report/sheet.h"
#include <functional>

namespace report {

// Where two pictures of one scene differ, beside where they may.
struct SeenChange {
    std::size_t pixels = 0; // of the picture
    std::size_t allowed = 0; // that show what the change is about
    std::size_t within = 0, elsewhere = 0; // of those that differ
};

// isAllowed: whether what a pixel shows first is what the change is about.
[[nodiscard]] SeenChange seenChange(const Stage& stage, const Picture& before, const Picture& after,
    const std::function<bool(const HitInfo&)>& isAllowed);

// about: in words, such as "mirrors".
[[nodiscard]] Claim claimOf(const SeenChange& change, const std::string& about);

}
