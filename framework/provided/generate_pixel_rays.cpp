#include "provided/marks.h"
#include "render.h"
#include "values/centre_ray.h"
#include "values/even_numbers.h"

const char provided::pixelRaysMark = 0;

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
    return { values::centreRay(camera, pixel, screenResolution) };
}
