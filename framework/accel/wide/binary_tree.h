#pragma once
#include "accel/wide/box.h"
#include "accel/wide/large_pages.h"
#include "accel/wide/node.h"
#include <span>

namespace accel::wide {

// A node of the binary tree, and how best to make wide ones of what is below it. A cache line.
struct BinaryNode {
    [[nodiscard]] bool isLeaf() const { return children[0] == 0; }

    Box box;
    uint32_t children[2]; // both 0: a leaf
    uint32_t first, numReferences; // of a leaf: which; else: how many are below

    // As at most i + 1 boxes: how many of them are the first child's; 0: as i boxes; of one box, 0: it is a block.
    uint8_t share[width];
};
static_assert(sizeof(BinaryNode) == 64);

struct BinaryTree {
    LargeArray<BinaryNode> nodes; // the root first; not all are in use; none if there is nothing to meet
    LargeArray<Reference> references; // likewise
};

// A tree by the surface area heuristic over triangles, cut in space where that pays. The same for any number of
// threads. Those with a coordinate that is not finite are left out.
[[nodiscard]] BinaryTree buildBinaryTree(std::span<const Triangle> triangles);

}
