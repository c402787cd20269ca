#pragma once
#include "debug/strokes.h"
#include <optional>

namespace gui {

// Draws strokes over the picture in this area of the window. Those of a shape that is selected stand out.
void drawStrokes(const std::vector<debug::Stroke>& strokes, std::optional<std::size_t> selected, const glm::vec2& first,
    const glm::vec2& last);

}
