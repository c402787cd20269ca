#pragma once
#include "common.h"
#include <span>

namespace truth {

// A point of a diffuse surface.
struct Receiver {
    glm::dvec3 point;
    glm::dvec3 normal; // unit, on the lit side
    glm::dvec3 kd;
};

// The mean over the light of color * kd * max(n.l, 0) where it is visible: what computeContributionSegmentLight and
// computeContributionParallelogramLight approach with many samples, for Lambert's model with shadows. To 1e-10 of the
// light's colour.
//
// blocker: the corners of a convex and flat polygon between the point and all of the light, or none.
[[nodiscard]] glm::dvec3 contribution(
    const SegmentLight& light, const Receiver& receiver, std::span<const glm::dvec3> blocker);
[[nodiscard]] glm::dvec3 contribution(
    const ParallelogramLight& light, const Receiver& receiver, std::span<const glm::dvec3> blocker);

}
