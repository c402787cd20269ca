#include "accel/wide/collapse_cost.h"
#include <algorithm>
#include <limits>

namespace accel::wide {
namespace {

    constexpr float nodeCost = 1.5f;
    constexpr float blockCost = 1.0f; // whether full or not: its triangles are tested together

    constexpr float infinity = std::numeric_limits<float>::infinity();

    struct Distribution {
        float cost;
        uint8_t share;
    };

    // So many boxes, some for either child.
    Distribution distribute(const CollapseCosts& first, const CollapseCosts& second, std::size_t numBoxes)
    {
        Distribution best { infinity, static_cast<uint8_t>(numBoxes / 2) }; // where areas are too large for a float
        for (std::size_t share = 1; share < numBoxes; ++share)
            if (const float cost = first[share - 1] + second[numBoxes - share - 1]; cost < best.cost)
                best = { cost, static_cast<uint8_t>(share) };
        return best;
    }

    float costOfBlock(const BinaryNode& node)
    {
        return node.numReferences <= width ? node.box.halfArea() * blockCost : infinity;
    }

}

CollapseCosts collapseLeaf(BinaryNode& leaf)
{
    std::ranges::fill(leaf.share, uint8_t { 0 });
    CollapseCosts costs;
    costs.fill(costOfBlock(leaf));
    return costs;
}

CollapseCosts collapseInner(BinaryNode& node, const CollapseCosts& first, const CollapseCosts& second)
{
    CollapseCosts costs;
    const Distribution asNode = distribute(first, second, width);
    const float nodeAndChildren = node.box.halfArea() * nodeCost + asNode.cost, block = costOfBlock(node);
    const bool isBlock = node.numReferences <= width && !(nodeAndChildren < block);
    costs[0] = isBlock ? block : nodeAndChildren;
    node.share[0] = isBlock ? uint8_t { 0 } : asNode.share;
    for (std::size_t i = 1; i < width; ++i) {
        const Distribution boxes = i == width - 1 ? asNode : distribute(first, second, i + 1);
        const bool fewer = costs[i - 1] <= boxes.cost;
        costs[i] = fewer ? costs[i - 1] : boxes.cost;
        node.share[i] = fewer ? uint8_t { 0 } : boxes.share;
    }
    return costs;
}

}
