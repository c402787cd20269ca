#pragma once
#include "bvh_primitives.h"
#include "render.h"
#include "scene.h"
#include <framework/ray.h>
#include <memory>
#include <vector>

struct BVH : public BVHInterface {
    static constexpr uint32_t LeafSize = 4; // primitives in a leaf, at most
    static constexpr uint32_t RootIndex = 0;

    // The scene's meshes must stay as they are: primitives may be made of them later.
    BVH(const Scene& scene, const Features& features);

    // To implement: see BVHInterface.
    bool intersect(RenderState& state, Ray& ray, HitInfo& hitInfo) const override;

    [[nodiscard]] std::span<const Node> nodes() const override { return m_nodes; }
    [[nodiscard]] std::span<Node> nodes() override { return m_nodes; }
    [[nodiscard]] std::span<const Primitive> primitives() const override { return m_primitives; }
    [[nodiscard]] std::span<Primitive> primitives() override { return m_primitives; }
    [[nodiscard]] std::size_t numPrimitives() const override { return m_primitives.size(); }
    [[nodiscard]] const Primitive& primitive(std::size_t index, Primitive& room) const override
    {
        return m_primitives.at(index, room);
    }

    [[nodiscard]] uint32_t numLevels() const override { return m_numLevels; }
    [[nodiscard]] uint32_t numLeaves() const override { return m_numLeaves; }
    [[nodiscard]] const accel::WideTree* wideTree() const override;

    void debugDrawLevel(int level); // the boxes of a level; the root is level 0
    void debugDrawLeaf(int leafIndex); // the box and the triangles of a leaf; the first is 1

private:
    uint32_t m_numLevels = 0;
    uint32_t m_numLeaves = 0;
    std::vector<Node> m_nodes;
    BVHPrimitives m_primitives; // to be used like a vector
    std::shared_ptr<accel::TreeOnDemand> m_wideTree;

    // In the 2023-24 edition these were the student's: declared so that such files compile, defined by them alone.
    uint32_t nextNodeIdx();
    Node buildLeafData(const Scene&, const Features&, const AxisAlignedBox&, std::span<Primitive>);
    Node buildNodeData(const Scene&, const Features&, const AxisAlignedBox&, uint32_t leftChild, uint32_t rightChild);
    void buildRecursive(const Scene&, const Features&, std::span<Primitive>, uint32_t nodeIndex);
    void buildNumLevels();
    void buildNumLeaves();
};

// Provided: the closest hit by the library's own traversal, with the result of BVHInterface::intersect.
bool intersectRayWithBVH(RenderState& state, const BVHInterface& bvh, Ray& ray, HitInfo& hitInfo);

// Provided: whether the ray meets anything at a distance in [0, ray.t], by the library's own traversal.
[[nodiscard]] bool isOccludedByBVH(RenderState& state, const BVHInterface& bvh, const Ray& ray);

// In the 2023-24 edition these were the student's.
[[nodiscard]] AxisAlignedBox computePrimitiveAABB(const BVHInterface::Primitive primitive);
[[nodiscard]] AxisAlignedBox computeSpanAABB(std::span<const BVHInterface::Primitive> primitives);
[[nodiscard]] glm::vec3 computePrimitiveCentroid(const BVHInterface::Primitive primitive);
[[nodiscard]] uint32_t computeAABBLongestAxis(const AxisAlignedBox& aabb);
size_t splitPrimitivesByMedian(
    const AxisAlignedBox& aabb, uint32_t axis, std::span<BVHInterface::Primitive> primitives);
