#include "render.h"
#include "values/even_numbers.h"
#include <framework/trackball.h>

std::vector<Ray> generatePixelRays(
    RenderState& state, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 screenResolution)
{
    if (state.features.numPixelSamples > 1) {
        if (values::EvenNumbers* even = state.sampler.even())
            even->expectPoints(state.features.numPixelSamples);
        return state.features.enableJitteredSampling
            ? generatePixelRaysStratified(state, camera, pixel, screenResolution)
            : generatePixelRaysUniform(state, camera, pixel, screenResolution);
    }
    const glm::vec2 centre = (glm::vec2(pixel) + 0.5f) / glm::vec2(screenResolution) * 2.0f - 1.0f;
    return { camera.generateRay(centre) };
}
