#include "bvh_interface.h"
#include "recursive.h"
#include "render.h"
#include "screen.h"
#include <framework/trackball.h>
#ifdef NDEBUG
#include <omp.h>
#endif

// A file as the course has them: renderImage stands in it. One stream of random numbers serves a whole row.
void renderImage(
    const Scene& scene, const BVHInterface& bvh, const Features& features, const Trackball& camera, Screen& screen)
{
#ifdef NDEBUG
#pragma omp parallel for schedule(dynamic)
#endif
    for (int y = 0; y < screen.resolution().y; y++) {
        RenderState state = { scene, features, bvh, Sampler(static_cast<uint32_t>(y)) };
        for (int x = 0; x < screen.resolution().x; x++) {
            auto rays = generatePixelRays(state, camera, { x, y }, screen.resolution());
            screen.setPixel(x, y, renderRays(state, rays));
        }
    }
}

static glm::vec2 toScreen(float x, float y, const glm::ivec2& size)
{
    return { (x + x) / size.x - 1, (y + y) / size.y - 1 };
}

std::vector<Ray> generatePixelRaysUniform(
    RenderState& state, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 screenResolution)
{
    std::vector<Ray> result(state.features.numPixelSamples);
    for (auto& ray : result) {
        float x = pixel.x + state.sampler.next_1d();
        float y = pixel.y + state.sampler.next_1d();
        ray = camera.generateRay(toScreen(x, y, screenResolution));
    }
    return result;
}

std::vector<Ray> generatePixelRaysStratified(
    RenderState& state, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 screenResolution)
{
    auto n = static_cast<uint32_t>(std::round(std::sqrt(float(state.features.numPixelSamples))));
    const float cell = 1.0f / n;
    std::vector<Ray> result;
    for (float left = 0; left < 1 - cell / 2; left += cell)
        for (float bottom = 0; bottom < 1 - cell / 2; bottom += cell) {
            float x = pixel.x + left + cell * state.sampler.next_1d();
            float y = pixel.y + bottom + cell * state.sampler.next_1d();
            result.push_back(camera.generateRay(toScreen(x, y, screenResolution)));
        }
    return result;
}
