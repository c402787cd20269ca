#include "accel/builder.h"
#include "accel/wide/tree_on_demand.h"
#include "bvh.h"

// So many primitives take a hundred megabytes. Hits are described sooner where they lie together, but beside a tree of
// more than these there is no room for them, unless somebody asks for them.
constexpr std::size_t manyPrimitives = 1 << 20;

BVH::BVH(const Scene& scene, const Features&)
{
    accel::Tree tree = accel::buildTree(scene, LeafSize);
    m_numLevels = tree.numLevels;
    m_numLeaves = tree.numLeaves;
    m_nodes = std::move(tree.nodes);
    m_primitives = std::move(tree.primitives);
    if (m_primitives.size() < manyPrimitives)
        (void)m_primitives.all();
    m_wideTree = std::make_shared<accel::TreeOnDemand>();
}
