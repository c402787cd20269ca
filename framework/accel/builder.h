#pragma once
#include "bvh_primitives.h"
#include "scene.h"
#include <vector>

namespace accel {

// Deepest level that a tree may reach: traversals keep a stack of this size.
inline constexpr uint32_t maxLevels = 64;

struct Tree {
    std::vector<BVHInterface::Node> nodes; // the root first
    BVHPrimitives primitives; // in the order of the leaves
    uint32_t numLevels = 0;
    uint32_t numLeaves = 0;
};

// A tree over all triangles of the scene by the surface area heuristic with bins, leaves of 1 to leafSize triangles.
// A scene without triangles gives one empty leaf. Wald 2007, "On fast Construction of SAH-based Bounding Volume
// Hierarchies".
[[nodiscard]] Tree buildTree(const Scene& scene, uint32_t leafSize);

}
