#include "grading/tiles.h"
#include <glm/common.hpp>

namespace grading {

std::vector<Tile> tilesOf(glm::ivec2 pictureSize, int width)
{
    std::vector<Tile> tiles;
    for (int y = 0; y < pictureSize.y; y += width)
        for (int x = 0; x < pictureSize.x; x += width)
            tiles.push_back({ { x, y }, glm::min(glm::ivec2(width), pictureSize - glm::ivec2(x, y)) });
    return tiles;
}

Sample sampleTile(const Replicates& replicates, const Tile& tile, int channel)
{
    const int perRow = replicates.size.x / finestTile;
    const glm::ivec2 first = tile.corner / finestTile, count = tile.size / finestTile;
    std::vector<double> means;
    for (const std::vector<glm::vec3>& picture : replicates.tiles) {
        double sum = 0.0;
        for (int y = first.y; y < first.y + count.y; ++y)
            for (int x = first.x; x < first.x + count.x; ++x)
                sum += static_cast<double>(picture[static_cast<std::size_t>(y * perRow + x)][channel]);
        means.push_back(sum / (count.x * count.y));
    }
    return summarize(means);
}

}
