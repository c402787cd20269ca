#pragma once
#include "accel/wide/node.h"
#include "accel/wide/splitter.h"

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

// A tree over the subtree's references, its root the first of the nodes: there must be room for twice the subtree's
// capacity. Large subtrees take all threads.
void buildBinaryTree(const Splitter& splitter, const Subtree& subtree, std::span<BinaryNode> nodes);

}
