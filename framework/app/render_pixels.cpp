#include "app/render_pixels.h"
#include "recursive.h"
#include "render.h"
#include "screen.h"
#include "values/even_numbers.h"
#include "values/needs_of.h"
#include <framework/trackball.h>
#include <tbb/parallel_for.h>

namespace app {

void renderPixels(const Scene& scene, const BVHInterface& bvh, const Features& features, const Trackball& camera,
    Screen& screen, uint32_t seed)
{
    const glm::ivec2 resolution = screen.resolution();
    const uint32_t seedOffset = seed * 0x9e3779b9u; // odd: distinct seeds stay distinct
    const SceneNeeds needs = values::needsOf(scene, features);
    tbb::parallel_for(0, resolution.y, [&](int y) {
        for (int x = 0; x < resolution.x; ++x) {
            const auto index = static_cast<uint32_t>(screen.indexAt(x, y));
            values::EvenNumbers even(seedOffset + index);
            RenderState state { scene, features, bvh,
                features.extra.enableOwenSampling ? Sampler(even) : Sampler(seedOffset + index), needs };
            if (features.numPixelSamples == 1) {
                const glm::vec2 centre = (glm::vec2(x, y) + 0.5f) / glm::vec2(resolution) * 2.0f - 1.0f;
                screen.setPixel(x, y, renderRay(state, camera.generateRay(centre)));
                continue;
            }
            const std::vector<Ray> rays = generatePixelRays(state, camera, { x, y }, resolution);
            screen.setPixel(x, y, renderRays(state, rays));
        }
    });
}

}
