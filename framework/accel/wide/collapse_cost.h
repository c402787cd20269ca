#pragma once
#include "accel/wide/binary_tree.h"

namespace accel::wide {

// Fills in cost and share of a node whose children have theirs. Ylitie, Karras, Laine 2017, "Efficient Incoherent Ray
// Traversal on GPUs Through Compressed Wide BVHs", section 3.2.
void computeCollapseCost(BinaryNode& node, const BinaryNode* nodes);

}
