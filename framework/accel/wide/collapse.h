#pragma once
#include "accel/wide/binary_tree.h"
#include "accel/wide/blocks.h"

namespace accel::wide {

struct WideNodes {
    std::vector<Node, LargePages<Node>>
        nodes; // the root first; none where there are so few triangles that all are tested
    Blocks blocks;
};

// Makes the wide tree that the costs of the binary one speak for. splitter: the one that it was built by.
[[nodiscard]] WideNodes collapse(std::span<const BinaryNode> nodes, const Splitter& splitter);

}
