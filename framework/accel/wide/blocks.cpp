#include "accel/wide/blocks.h"
#include <algorithm>

namespace accel::wide {
namespace {

    Block emptyBlock()
    {
        Block block;
        for (auto& axis : block.positions)
            for (auto& corner : axis)
                std::ranges::fill(corner, std::numeric_limits<float>::quiet_NaN());
        std::ranges::fill(block.primitives, ~uint32_t { 0 });
        return block;
    }

    Block makeBlock(std::span<const uint32_t> primitives, const Triangles& triangles)
    {
        Block block = emptyBlock();
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            block.primitives[i] = primitives[i];
            const Triangle triangle = triangles[primitives[i]];
            for (int axis = 0; axis < 3; ++axis)
                for (std::size_t corner = 0; corner < 3; ++corner)
                    block.positions[axis][corner][i] = triangle[corner][axis];
        }
        return block;
    }

}

void addBlocks(std::vector<uint32_t>& primitives, const Triangles& triangles, Blocks& blocks)
{
    std::ranges::sort(primitives); // parts of one triangle meet again
    primitives.erase(std::unique(primitives.begin(), primitives.end()), primitives.end());
    const std::span<const uint32_t> all(primitives);
    for (std::size_t first = 0; first < all.size(); first += width)
        blocks.push_back(makeBlock(all.subspan(first, std::min<std::size_t>(width, all.size() - first)), triangles));
}

}
