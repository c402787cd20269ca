#pragma once
#include "accel/wide/binary_tree.h"
#include "accel/wide/node.h"
#include <vector>

namespace accel::wide {

struct WideNodes {
    std::vector<Node, LargePages<Node>> nodes; // the root first
    std::vector<Block, LargePages<Block>> blocks;
};

// Makes the wide tree that the binary tree's costs speak for.
[[nodiscard]] WideNodes collapse(const BinaryTree& tree, std::span<const Triangle> triangles);

}
