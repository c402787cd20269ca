#pragma once
#include "common.h"
#include "fwd.h"
#include <array>
#include <cstdint>
#include <framework/ray.h>
#include <span>

namespace accel {
class WideTree;
class TreeOnDemand;
}

// A binary tree of boxes over the scene's triangles. Node 0 is the root.
struct BVHInterface {
    struct Primitive {
        uint32_t meshID; // index into Scene::meshes
        Vertex v0, v1, v2;

        [[nodiscard]] constexpr bool operator==(const Primitive&) const noexcept = default;
    };

    // A node has two children, or it is a leaf with a range of primitives:
    // - node: data = { index of the left child, index of the right child }
    // - leaf: data = { LeafBit | offset of the first primitive, number of primitives }
    struct Node {
        static constexpr uint32_t LeafBit = 1u << 31;

        AxisAlignedBox aabb;
        std::array<uint32_t, 2> data;

        [[nodiscard]] constexpr bool isLeaf() const { return (data[0] & LeafBit) == LeafBit; }
        [[nodiscard]] constexpr uint32_t primitiveOffset() const { return data[0] & ~LeafBit; }
        [[nodiscard]] constexpr uint32_t primitiveCount() const { return data[1]; }
        [[nodiscard]] constexpr uint32_t leftChild() const { return data[0]; }
        [[nodiscard]] constexpr uint32_t rightChild() const { return data[1]; }
    };
    static_assert(sizeof(Node) == 32, "two nodes share a cache line");

    virtual ~BVHInterface() = default;

    // Whether the ray meets a triangle or sphere at a distance in [0, ray.t]. If it does, ray.t is the closest such
    // distance and hitInfo describes the hit; if not, both are as they were.
    virtual bool intersect(RenderState& state, Ray& ray, HitInfo& hitInfo) const = 0;

    // Whether the ray meets anything at a distance in [0, ray.t]: what a shadow ray asks. The library's own tree stops
    // at the first that it finds; another's answers by its closest hit.
    [[nodiscard]] virtual bool isOccluded(RenderState& state, const Ray& ray) const
    {
        Ray shortened = ray;
        HitInfo unused;
        return intersect(state, shortened, unused);
    }

    [[nodiscard]] virtual std::span<const Node> nodes() const = 0;
    [[nodiscard]] virtual std::span<Node> nodes() = 0;
    [[nodiscard]] virtual std::span<const Primitive> primitives() const = 0;
    [[nodiscard]] virtual std::span<Primitive> primitives() = 0;
    // The same, for whoever does not look at all: of a large scene all are made when somebody first asks for them. One
    // that is not made yet is put into the room.
    [[nodiscard]] virtual std::size_t numPrimitives() const { return primitives().size(); }
    [[nodiscard]] virtual const Primitive& primitive(std::size_t index, Primitive& /*room*/) const
    {
        return primitives()[index];
    }

    [[nodiscard]] virtual uint32_t numLevels() const = 0;
    [[nodiscard]] virtual uint32_t numLeaves() const = 0;

    // The library's own tree over the same primitives, as they were when it was built; null if there is none.
    [[nodiscard]] virtual const accel::WideTree* wideTree() const { return nullptr; }
};
