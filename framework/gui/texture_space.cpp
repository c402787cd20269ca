#include "gui/texture_space.h"

namespace gui {

const Image* imageOf(const worker::TextureLookup& lookup, const std::vector<std::shared_ptr<const Image>>& textures)
{
    if (lookup.texture >= textures.size() || !textures[lookup.texture])
        return nullptr;
    const Image& image = *textures[lookup.texture];
    return lookup.size == glm::ivec2(image.width, image.height) ? &image : nullptr;
}

TexelRange texelsAround(const glm::vec2& place, glm::ivec2 size, int eachWay)
{
    // In this order a place that is not a number becomes 0: it comes from another process too.
    const glm::vec2 inside { std::min(std::max(0.0f, place.x), static_cast<float>(size.x)),
        std::min(std::max(0.0f, place.y), static_cast<float>(size.y)) };
    const glm::ivec2 nearestCorner { glm::round(inside) };
    return { nearestCorner - eachWay, nearestCorner + eachWay };
}

glm::ivec2 numCells(glm::ivec2 size, int most)
{
    return glm::min(size, glm::ivec2(most));
}

glm::ivec2 texelOfCell(glm::ivec2 cell, glm::ivec2 cells, glm::ivec2 size)
{
    return (2 * cell + 1) * size / (2 * cells);
}

}
