#pragma once
#include "gui/exchange.h"

namespace gui {

// A choice of what the picture shows, in the current ImGui window: the one that was made just now.
[[nodiscard]] std::optional<debug::Quantity> quantityCombo(debug::Quantity now);

// What the colours of a picture in this area of the window mean, and the value under the mouse. Nothing for a picture
// that is its own meaning.
void legend(const Picture& picture, glm::vec2 first, glm::vec2 last);

}
