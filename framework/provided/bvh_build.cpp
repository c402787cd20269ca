#include "accel/builder.h"
#include "accel/wide/tree.h"
#include "bvh.h"

static std::shared_ptr<const accel::WideTree> buildWideTree(std::span<const BVHInterface::Primitive> primitives)
{
    std::vector<accel::WideTree::Triangle> triangles;
    triangles.reserve(primitives.size());
    for (const auto& [meshID, v0, v1, v2] : primitives)
        triangles.push_back({ v0.position, v1.position, v2.position });
    return std::make_shared<const accel::WideTree>(triangles);
}

BVH::BVH(const Scene& scene, const Features&)
{
    accel::Tree tree = accel::buildTree(scene, LeafSize);
    m_numLevels = tree.numLevels;
    m_numLeaves = tree.numLeaves;
    m_nodes = std::move(tree.nodes);
    m_primitives = std::move(tree.primitives);
    m_wideTree = buildWideTree(m_primitives);
}
