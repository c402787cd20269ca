#pragma once
#include "scene.h"
#include "worker/debug_ray.h"

namespace gui {

// A rectangle of texels: from `first` up to `end`, which is beyond it.
struct TexelRange {
    glm::ivec2 first { 0 }, end { 0 };

    [[nodiscard]] bool contains(glm::ivec2 texel) const
    {
        return glm::all(glm::lessThanEqual(first, texel)) && glm::all(glm::lessThan(texel, end));
    }
};

// The texture that was looked up; null if another process speaks of one that is not there, or is another.
[[nodiscard]] const Image* imageOf(
    const worker::TextureLookup& lookup, const std::vector<std::shared_ptr<const Image>>& textures);

// As many texels each way around a place, the nearest place of the texture if that is outside. Not all of them need be
// in the texture. Place: in texels.
[[nodiscard]] TexelRange texelsAround(const glm::vec2& place, glm::ivec2 size, int eachWay);

// A texture as few cells: one a texel, but at most so many in a row and in a column.
[[nodiscard]] glm::ivec2 numCells(glm::ivec2 size, int most);
// The texel in the middle of a cell.
[[nodiscard]] glm::ivec2 texelOfCell(glm::ivec2 cell, glm::ivec2 cells, glm::ivec2 size);

[[nodiscard]] inline glm::vec3 colorOf(const Image& image, glm::ivec2 texel)
{
    return image.get_pixel(texel.y * image.width + texel.x);
}

}
