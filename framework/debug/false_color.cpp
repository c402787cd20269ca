#include "debug/false_color.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vector_relational.hpp>

namespace debug {

Range rangeOf(Quantity quantity, std::span<const glm::vec3> values)
{
    if (!isNumber(quantity))
        return { quantity == Quantity::Normal ? -1.0f : 0.0f, 1.0f };
    constexpr float infinity = std::numeric_limits<float>::infinity();
    Range range { infinity, -infinity };
    for (const glm::vec3& value : values)
        if (std::isfinite(value.x)) {
            range.lowest = std::min(range.lowest, value.x);
            range.highest = std::max(range.highest, value.x);
        }
    if (range.lowest > range.highest)
        return {};
    return { quantity == Quantity::Distance ? range.lowest : 0.0f, range.highest };
}

// Green 2011, "A colour scheme for the display of astronomical intensity images": a helix around the grey diagonal of
// the cube of colours, so that the luminance is the intensity.
static glm::vec3 cubehelix(float intensity)
{
    constexpr float start = 0.5f, rotations = -1.5f;
    const float angle = glm::two_pi<float>() * (start / 3.0f + rotations * intensity);
    const float amplitude = intensity * (1.0f - intensity) / 2.0f;
    const glm::vec3 alongCosine { -0.14861f, -0.29227f, 1.97294f };
    const glm::vec3 alongSine { 1.78277f, -0.90649f, 0.0f };
    return glm::clamp(
        intensity + amplitude * (std::cos(angle) * alongCosine + std::sin(angle) * alongSine), 0.0f, 1.0f);
}

glm::vec3 heat(float fraction)
{
    constexpr float darkest = 0.15f; // the smallest number is not to look like nothing
    return cubehelix(glm::mix(darkest, 1.0f, glm::clamp(fraction, 0.0f, 1.0f)));
}

glm::vec3 falseColor(Quantity quantity, const glm::vec3& value, const Range& range)
{
    if (quantity == Quantity::Color)
        return value;
    if (value == nothing)
        return glm::vec3(0.0f);
    if (glm::any(glm::isnan(value)))
        return { 1.0f, 0.0f, 1.0f }; // no vector's and no number's
    const float extent = std::max(range.highest - range.lowest, std::numeric_limits<float>::min());
    const glm::vec3 fraction = (value - range.lowest) / extent;
    return isNumber(quantity) ? heat(fraction.x) : glm::clamp(fraction, 0.0f, 1.0f);
}

std::vector<glm::vec3> falseColors(Quantity quantity, std::vector<glm::vec3> values, const Range& range)
{
    for (glm::vec3& value : values)
        value = falseColor(quantity, value, range);
    return values;
}

}
