#pragma once
#include "debug/recording.h"
#include <span>
#include <string>
#include <vector>

namespace grading {

// Of what was drawn, what the submission's own file may have drawn: without what the framework draws (the ray up to
// each hit, the rays to lights) and what the reference draws in the files that it stands in for. The renderRay of a
// submission draws the framework's rays instead, so these go too. Known by their looks and their order, so the ray must
// be one that has no branches. hits: the path of the ray, from the camera on; recorded: those that a recording has,
// none where renderRay is the submission's.
[[nodiscard]] std::vector<debug::Drawn> drawnByFile(const std::string& file, std::span<const debug::Shape> shapes,
    std::span<const debug::Hit> hits, std::span<const debug::Hit> recorded);

}
