#pragma once
#include "fwd.h"
#include "worker/debug_ray.h"

namespace worker {

// What the ray through the middle of a pixel does, and what is drawn on its way. The camera of the answer is the one
// that the picture is to be drawn with. Throws std::invalid_argument for a pixel beyond the picture.
[[nodiscard]] DebugRay followRay(const Scene& scene, const Features& features, const BVHInterface& bvh,
    const Trackball& camera, glm::ivec2 pixel, glm::ivec2 size);

}
