#include "app/render_pixels.h"
#include "recursive.h"
#include "render.h"
#include "screen.h"
#include "values/centre_ray.h"
#include "values/even_numbers.h"
#include "values/needs_of.h"
#include <tbb/parallel_for.h>

namespace app {

static glm::vec3 renderPixel(RenderState& state, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 resolution)
{
    if (!state.needs.pixelRays)
        return renderRay(state, values::centreRay(camera, pixel, resolution));
    return renderRays(state, generatePixelRays(state, camera, pixel, resolution));
}

void renderPixels(const Scene& scene, const BVHInterface& bvh, const Features& features, const Trackball& camera,
    Screen& screen, uint32_t seed)
{
    const glm::ivec2 resolution = screen.resolution();
    const uint32_t seedOffset = seed * 0x9e3779b9u; // odd: distinct seeds stay distinct
    const SceneNeeds needs = values::needsOf(scene, features);
    tbb::parallel_for(0, resolution.y, [&](int y) {
        RenderState state { scene, features, bvh, Sampler(0), needs };
        for (int x = 0; x < resolution.x; ++x) {
            const uint32_t pixelSeed = seedOffset + static_cast<uint32_t>(screen.indexAt(x, y));
            values::EvenNumbers even(pixelSeed);
            state.sampler = features.extra.enableOwenSampling ? Sampler(even) : Sampler(pixelSeed);
            screen.setPixel(x, y, renderPixel(state, camera, { x, y }, resolution));
        }
    });
}

}
