#include "render.h"
#include <framework/trackball.h>

// The camera ray through a point given in pixels, (0, 0) at the bottom left of the screen.
static Ray rayThrough(const Trackball& camera, const glm::vec2& position, glm::ivec2 screenResolution)
{
    return camera.generateRay(position / glm::vec2(screenResolution) * 2.0f - 1.0f);
}

std::vector<Ray> generatePixelRaysUniform(
    RenderState& state, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 screenResolution)
{
    const uint32_t numSamples = state.features.numPixelSamples;
    std::vector<Ray> rays;
    rays.reserve(numSamples);
    for (uint32_t i = 0; i < numSamples; ++i)
        rays.push_back(rayThrough(camera, glm::vec2(pixel) + state.sampler.next_2d(), screenResolution));
    return rays;
}

std::vector<Ray> generatePixelRaysStratified(
    RenderState& state, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 screenResolution)
{
    const auto n = static_cast<int>(std::round(std::sqrt(static_cast<float>(state.features.numPixelSamples))));
    std::vector<Ray> rays;
    rays.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const glm::vec2 inPixel = (glm::vec2(x, y) + state.sampler.next_2d()) / static_cast<float>(n);
            rays.push_back(rayThrough(camera, glm::vec2(pixel) + inPixel, screenResolution));
        }
    }
    return rays;
}
