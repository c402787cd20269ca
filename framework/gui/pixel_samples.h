#pragma once
#include "common.h"
#include <optional>

namespace gui {

// How many cells a pixel has in a row when its samples are to be one in each; none when they are not.
[[nodiscard]] std::optional<int> cellsInRow(const Features& features);

// Whether a sample lies in [0, 1] x [0, 1], but for the rounding of those who found out where it goes.
[[nodiscard]] bool isInPixel(const glm::vec2& sample);

}
