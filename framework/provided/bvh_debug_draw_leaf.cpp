#include "bvh.h"
#include "draw.h"

void BVH::debugDrawLeaf(int leafIndex)
{
    int leaf = 0;
    for (const Node& node : m_nodes) {
        if (!node.isLeaf() || ++leaf != leafIndex)
            continue;
        drawAABB(node.aabb, DrawMode::Wireframe);
        for (uint32_t i = 0; i < node.primitiveCount(); ++i) {
            const Primitive& p = m_primitives[node.primitiveOffset() + i];
            drawTriangle(p.v0, p.v1, p.v2);
        }
    }
}
