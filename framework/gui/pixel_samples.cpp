#include "gui/pixel_samples.h"

namespace gui {

std::optional<int> cellsInRow(const Features& features)
{
    const auto row = std::lround(std::sqrt(static_cast<double>(features.numPixelSamples)));
    if (!features.enableJitteredSampling || row * row != features.numPixelSamples)
        return std::nullopt;
    return static_cast<int>(row);
}

bool isInPixel(const glm::vec2& sample)
{
    // Projected to a picture of some thousand pixels, where neighbouring floats are 2^-12 apart, in a few roundings.
    constexpr float rounding = 1e-3f;
    return glm::all(glm::greaterThanEqual(sample, glm::vec2(-rounding)))
        && glm::all(glm::lessThanEqual(sample, glm::vec2(1.0f + rounding)));
}

}
