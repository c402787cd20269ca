#pragma once
#include "debug/quantity.h"
#include <span>

namespace debug {

struct Range {
    float lowest = 0.0f, highest = 0.0f;
};

// Of a picture's numbers, from 0 for counts; those that are not finite do not count. Vectors have a range of their own.
[[nodiscard]] Range rangeOf(Quantity quantity, std::span<const glm::vec3> values);

// A colour for a number in [0, 1]: the larger, the lighter, so that it reads in print as well.
[[nodiscard]] glm::vec3 heat(float fraction);

// Vectors as red, green and blue: normals from -1 to 1, the others from 0 to 1. Numbers as heat over the range.
// Black where nothing is, magenta for NaN. Colours stay as they are.
[[nodiscard]] glm::vec3 falseColor(Quantity quantity, const glm::vec3& value, const Range& range);

// Of a whole picture.
[[nodiscard]] std::vector<glm::vec3> falseColors(Quantity quantity, std::vector<glm::vec3> values, const Range& range);

}
