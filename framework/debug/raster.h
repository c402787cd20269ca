#pragma once
#include "debug/strokes.h"
#include <span>

namespace debug {

// Draws strokes over a picture, row 0 at the bottom; lines are two pixels wide.
void drawOver(std::span<glm::vec3> pixels, glm::ivec2 size, const std::vector<Stroke>& strokes);

}
