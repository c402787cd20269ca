#include "accel/traversal.h"
#include "accel/box_test.h"
#include "accel/builder.h"
#include "debug/tally.h"
#include <array>
#include <span>
#include <utility>

namespace accel {
namespace {

    using Node = BVHInterface::Node;
    using Primitive = BVHInterface::Primitive;

    struct Visit {
        uint32_t node;
        float entry; // where the ray enters the node's box
    };

    // Stands in for debug::Tally where nobody counts.
    struct NoTally {
        static void addNode() { }
        static void addTriangles(std::size_t) { }
    };

    const Primitive* closestOf(std::span<const Primitive> primitives, Ray& ray, TriangleHit& hit)
    {
        const Primitive* closest = nullptr;
        for (const Primitive& p : primitives) {
            if (testTriangle(p.v0.position, p.v1.position, p.v2.position, ray, hit)) {
                ray.t = hit.t;
                closest = &p;
            }
        }
        return closest;
    }

}

template <typename Tally> static const Primitive* search(const BVHInterface& bvh, Ray& ray, TriangleHit& hit)
{
    const std::span<const Node> nodes = bvh.nodes();
    const std::span<const Primitive> primitives = bvh.primitives();
    if (nodes.empty() || bvh.numLevels() > maxLevels) { // somebody else's tree, too deep for the stack
        Tally::addTriangles(primitives.size());
        return closestOf(primitives, ray, hit);
    }

    const RayForBoxes forBoxes { ray };
    std::array<Visit, maxLevels> stack; // one entry a level at most: the farther sibling
    std::size_t stackSize = 0;
    Visit current { 0, 0.0f };
    if (!testBox(nodes[0].aabb, forBoxes, ray.t, current.entry))
        return nullptr;

    const Primitive* closest = nullptr;
    for (;;) {
        Tally::addNode();
        const Node& node = nodes[current.node];
        if (node.isLeaf()) {
            const auto leaf = primitives.subspan(node.primitiveOffset(), node.primitiveCount());
            Tally::addTriangles(leaf.size());
            if (const Primitive* closer = closestOf(leaf, ray, hit))
                closest = closer;
        } else {
            Visit near { node.leftChild(), 0.0f };
            Visit far { node.rightChild(), 0.0f };
            const bool meetsNear = testBox(nodes[near.node].aabb, forBoxes, ray.t, near.entry);
            const bool meetsFar = testBox(nodes[far.node].aabb, forBoxes, ray.t, far.entry);
            if (meetsNear && meetsFar) {
                if (far.entry < near.entry)
                    std::swap(near, far);
                stack[stackSize++] = far;
            }
            if (meetsNear || meetsFar) {
                current = meetsNear ? near : far;
                continue;
            }
        }
        do { // the next node that is not behind what was found since it was put aside
            if (stackSize == 0)
                return closest;
            current = stack[--stackSize];
        } while (current.entry > ray.t);
    }
}

const Primitive* findClosest(const BVHInterface& bvh, Ray& ray, TriangleHit& hit)
{
    return debug::Tally::isOpen() ? search<debug::Tally>(bvh, ray, hit) : search<NoTally>(bvh, ray, hit);
}

}
