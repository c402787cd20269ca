// Weak: this object comes with all of its functions, and a submission may define only some of them.
#include "render.h"
#include "not_written_yet.h"
#include <framework/trackball.h>

namespace {

std::vector<Ray> raysThroughCentre(
    std::size_t count, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 screenResolution)
{
    const glm::vec2 centre = (glm::vec2(pixel) + 0.5f) / glm::vec2(screenResolution) * 2.0f - 1.0f;
    return std::vector<Ray>(count, camera.generateRay(centre));
}

}

// A file of the 2023-24 edition defines the older name, one of 2024-25 the newer: either links.
[[gnu::weak]] std::vector<Ray> generatePixelRaysUniform(
    RenderState& state, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 screenResolution)
{
    return generatePixelRaysMultisampled(state, camera, pixel, screenResolution);
}

[[gnu::weak]] std::vector<Ray> generatePixelRaysMultisampled(
    RenderState& state, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 screenResolution)
{
    notWrittenYet("generatePixelRaysUniform");
    return raysThroughCentre(state.features.numPixelSamples, camera, pixel, screenResolution);
}

[[gnu::weak]] std::vector<Ray> generatePixelRaysStratified(
    RenderState& state, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 screenResolution)
{
    notWrittenYet("generatePixelRaysStratified");
    const auto n = static_cast<std::size_t>(std::lround(std::sqrt(state.features.numPixelSamples)));
    return raysThroughCentre(n * n, camera, pixel, screenResolution);
}
