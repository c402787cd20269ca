#pragma once
#include "accel/counting_bvh.h"
#include "fwd.h"
#include "scene_needs.h"
#include "worker/view.h"

namespace worker {

// The view's quantity in one pixel, as the submission's functions have it; debug::nothing where there is no surface to
// measure. The lights are the scene's.
[[nodiscard]] glm::vec3 measurePixel(const Scene& scene, const accel::CountingBVH& bvh, const View& view,
    glm::ivec2 pixel, const SceneNeeds& needs = {});

}
