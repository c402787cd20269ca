#include "accel/builder.h"
#include "bvh.h"

BVH::BVH(const Scene& scene, const Features&)
{
    accel::Tree tree = accel::buildTree(scene, LeafSize);
    m_numLevels = tree.numLevels;
    m_numLeaves = tree.numLeaves;
    m_nodes = std::move(tree.nodes);
    m_primitives = std::move(tree.primitives);
}
