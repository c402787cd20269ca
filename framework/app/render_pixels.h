#pragma once
#include "fwd.h"
#include <cstdint>

namespace app {

// Renders every pixel on all cores. A pixel's random numbers follow from the seed and its place alone, so the picture
// is the same, bit for bit, for any number of threads.
void renderPixels(const Scene& scene, const BVHInterface& bvh, const Features& features, const Trackball& camera,
    Screen& screen, uint32_t seed = 0);

}
