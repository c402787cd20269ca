#pragma once
#include "debug/strokes.h"
#include <span>
#include <string>

namespace debug {

// Strokes over a picture, as a vector drawing of that size. Each stroke has the index of its shape as data-shape.
// background: a PNG file, which becomes part of the drawing.
[[nodiscard]] std::string toSvg(
    const std::vector<Stroke>& strokes, glm::ivec2 size, std::span<const std::byte> background);

}
