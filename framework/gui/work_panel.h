#pragma once
#include "gui/exchange.h"

namespace gui {

// A window with what the picture needs and what is done for it, in the words of --explain. At first it stands in this
// corner, of which it is on the right and above.
void workPanel(const Picture& picture, bool skips, bool& isOpen, glm::vec2 corner);

}
