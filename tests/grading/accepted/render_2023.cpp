#include "render.h"
#include "sampler.h"
#include <framework/trackball.h>

// The older name of generatePixelRaysUniform.
std::vector<Ray> generatePixelRaysMultisampled(
    RenderState& state, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 screenResolution)
{
    std::vector<Ray> rays;
    while (rays.size() < state.features.numPixelSamples) {
        glm::vec2 position = (glm::vec2(pixel) + state.sampler.next_2d()) / glm::vec2(screenResolution) * 2.f - 1.f;
        rays.push_back(camera.generateRay(position));
    }
    return rays;
}

std::vector<Ray> generatePixelRaysStratified(
    RenderState& state, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 screenResolution)
{
    const int n = std::lround(std::sqrt(state.features.numPixelSamples));
    const glm::vec2 pixelSize = 2.0f / glm::vec2(screenResolution);
    const glm::vec2 cellSize = pixelSize / float(n);
    const glm::vec2 corner = glm::vec2(pixel) * pixelSize - 1.0f;
    std::vector<Ray> rays;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            rays.push_back(camera.generateRay(corner + (glm::vec2(i, j) + state.sampler.next_2d()) * cellSize));
    return rays;
}
