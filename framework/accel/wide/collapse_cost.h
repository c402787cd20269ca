#pragma once
#include "accel/wide/binary_tree.h"

namespace accel::wide {

// The least cost of a subtree as at most i + 1 boxes of a wide node.
using CollapseCosts = std::array<float, width>;

// Fill in the node's share. The costs are those of its children. Ylitie, Karras, Laine 2017, "Efficient Incoherent Ray
// Traversal on GPUs Through Compressed Wide BVHs", section 3.2.
[[nodiscard]] CollapseCosts collapseLeaf(BinaryNode& leaf);
[[nodiscard]] CollapseCosts collapseInner(BinaryNode& node, const CollapseCosts& first, const CollapseCosts& second);

}
