#pragma once
#include "debug/strokes.h"
#include <optional>

namespace gui {

// The shape whose line or edge runs nearest to a place, if any does within the radius; where none does, the one whose
// area covers the place. Of several the one that is drawn last, above the others. In pixels, from the bottom left.
[[nodiscard]] std::optional<std::size_t> shapeAt(
    const std::vector<debug::Stroke>& strokes, const glm::vec2& place, float radius);

}
