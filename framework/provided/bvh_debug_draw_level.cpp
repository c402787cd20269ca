#include "bvh.h"
#include "draw.h"

namespace {

void drawLevel(std::span<const BVHInterface::Node> nodes, uint32_t index, int levelsBelow)
{
    const BVHInterface::Node& node = nodes[index];
    if (levelsBelow == 0)
        return drawAABB(node.aabb, DrawMode::Wireframe);
    if (node.isLeaf())
        return;
    drawLevel(nodes, node.leftChild(), levelsBelow - 1);
    drawLevel(nodes, node.rightChild(), levelsBelow - 1);
}

}

void BVH::debugDrawLevel(int level)
{
    drawLevel(m_nodes, RootIndex, level);
}
