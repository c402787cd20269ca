#pragma once
#include "grading/stress/judgement.h"
#include "grading/stress/probes/rays.h"

namespace stress {

[[nodiscard]] std::string describe(const Soup& soup);

// That each ray meets what is closest in the soup, by trying all triangles in double precision; where roundings decide,
// whatever they may decide. allowed: how many, as of a Crossing.
[[nodiscard]] Judgement judgeClosest(const Soup& soup, const std::vector<MetInSoup>& answers, double allowed);

// That each ray meets anything at all.
[[nodiscard]] Judgement judgeHits(const Soup& soup, const std::vector<MetInSoup>& answers);

}
