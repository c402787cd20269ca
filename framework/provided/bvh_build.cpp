#include "accel/builder.h"
#include "accel/wide/tree_on_demand.h"
#include "bvh.h"

BVH::BVH(const Scene& scene, const Features&)
{
    accel::Tree tree = accel::buildTree(scene, LeafSize);
    m_numLevels = tree.numLevels;
    m_numLeaves = tree.numLeaves;
    m_nodes = std::move(tree.nodes);
    m_primitives = std::move(tree.primitives);
    m_wideTree = std::make_shared<accel::TreeOnDemand>();
}
