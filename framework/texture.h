#pragma once
#include "common.h"
#include "fwd.h"
#include <framework/image.h>

// Texel (i, j) covers [i, i+1) x [j, j+1) of texCoord * (width, height), so its centre lies at a half-integer, and row
// 0 is the row that v = 0 addresses. Coordinates beyond the edge take the edge's texels.

// To implement: the colour of the texel that covers texCoord.
[[nodiscard]] glm::vec3 sampleTextureNearest(const Image& image, const glm::vec2& texCoord);

// To implement: the colours of the four texels whose centres surround texCoord, weighted linearly in each direction.
[[nodiscard]] glm::vec3 sampleTextureBilinear(const Image& image, const glm::vec2& texCoord);
