#include "debug/false_color.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
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

// Viridis, Smith and van der Walt 2015: equal steps look equal, to colour-blind readers too. Nine of its colours.
static constexpr auto viridis = std::to_array<glm::vec3>({
    { 0.267f, 0.005f, 0.329f },
    { 0.278f, 0.176f, 0.482f },
    { 0.231f, 0.322f, 0.545f },
    { 0.173f, 0.447f, 0.557f },
    { 0.129f, 0.569f, 0.549f },
    { 0.157f, 0.682f, 0.502f },
    { 0.369f, 0.788f, 0.384f },
    { 0.678f, 0.863f, 0.188f },
    { 0.993f, 0.906f, 0.144f },
});

glm::vec3 heat(float fraction)
{
    const float place = glm::clamp(fraction, 0.0f, 1.0f) * static_cast<float>(viridis.size() - 1);
    const auto before = std::min(static_cast<std::size_t>(place), viridis.size() - 2);
    return glm::mix(viridis[before], viridis[before + 1], place - static_cast<float>(before));
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
