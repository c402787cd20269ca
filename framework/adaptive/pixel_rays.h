#pragma once
#include "common.h"
#include "fwd.h"
#include "scene_needs.h"
#include <framework/trackball.h>

namespace adaptive {

// The rays of every pixel: each pixel's are one long sequence, of evenly spread numbers that follow from the seed and
// the pixel's place alone. A code that brings random numbers of its own must not begin them anew in each call.
//
// Each ray takes one sample of each light. Its many rays spread those over the light as well as many samples of each
// would, and see more of the pixel at the same price.
class PixelRays {
public:
    PixelRays(const Scene& scene, const BVHInterface& bvh, const Features& features, const Trackball& camera,
        glm::ivec2 size, uint32_t seed);

    // The mean colour of numRays of them, 2^k and at least 2, from the first on, a multiple of numRays.
    [[nodiscard]] glm::dvec3 mean(std::size_t pixel, uint32_t firstRay, uint32_t numRays) const;

private:
    [[nodiscard]] glm::dvec3 meanOfFew(
        const Features& features, std::size_t pixel, uint32_t firstRay) const; // features.numPixelSamples

    const Scene& m_scene;
    const BVHInterface& m_bvh;
    const Features m_features;
    const SceneNeeds m_needs;
    const Trackball& m_camera;
    glm::ivec2 m_size;
    uint32_t m_seed;
};

}
