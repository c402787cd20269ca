#pragma once
#include "grading/replicates.h"
#include "grading/welch.h"
#include <glm/vec2.hpp>
#include <vector>

namespace grading {

// A part of a picture.
struct Tile {
    glm::ivec2 corner { 0 }; // bottom left pixel
    glm::ivec2 size { 0 }; // pixels

    [[nodiscard]] glm::ivec2 centre() const { return corner + size / 2; }
};

// A picture cut into tiles of this width, a multiple of finestTile. Those at the right and the top may be smaller.
[[nodiscard]] std::vector<Tile> tilesOf(glm::ivec2 pictureSize, int width);

// The mean of a channel over a tile, sampled by the replicates.
[[nodiscard]] Sample sampleTile(const Replicates& replicates, const Tile& tile, int channel);

}
