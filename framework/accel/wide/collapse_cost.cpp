#include "accel/wide/collapse_cost.h"
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
    Distribution distribute(const BinaryNode& a, const BinaryNode& b, std::size_t numBoxes)
    {
        Distribution best { infinity, static_cast<uint8_t>(numBoxes / 2) }; // where areas are too large for a float
        for (std::size_t share = 1; share < numBoxes; ++share)
            if (const float cost = a.cost[share - 1] + b.cost[numBoxes - share - 1]; cost < best.cost)
                best = { cost, static_cast<uint8_t>(share) };
        return best;
    }

}

void computeCollapseCost(BinaryNode& node, const BinaryNode* nodes)
{
    const float area = node.box.halfArea();
    const bool fitsBlock = node.numReferences <= width;
    node.cost[0] = fitsBlock ? area * blockCost : infinity;
    node.share[0] = 0;
    if (node.isLeaf()) {
        std::fill(std::begin(node.cost), std::end(node.cost), node.cost[0]);
        std::fill(std::begin(node.share), std::end(node.share), uint8_t { 0 });
        return;
    }
    const BinaryNode &a = nodes[node.children[0]], &b = nodes[node.children[1]];
    const Distribution asNode = distribute(a, b, width);
    if (const float cost = area * nodeCost + asNode.cost; !fitsBlock || cost < node.cost[0]) {
        node.cost[0] = cost;
        node.share[0] = asNode.share;
    }
    for (std::size_t i = 1; i < width; ++i) {
        const Distribution boxes = i == width - 1 ? asNode : distribute(a, b, i + 1);
        const bool fewer = node.cost[i - 1] <= boxes.cost;
        node.cost[i] = fewer ? node.cost[i - 1] : boxes.cost;
        node.share[i] = fewer ? uint8_t { 0 } : boxes.share;
    }
}

}
