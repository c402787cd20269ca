#pragma once
#include <cstdint>

namespace accel::wide {

inline constexpr int width = 16; // children of a node, triangles of a block

// A node or, if the highest bit is set, a block of triangles: where it lies in its array, in units of eight bytes,
// since addresses count in these at no cost.
using Child = uint32_t;
inline constexpr Child blockBit = 1u << 31;
inline constexpr uint64_t childUnit = 8;

// Sixteen boxes, two cache lines for each axis. Unused places hold boxes that no ray enters: from infinity to minus
// infinity.
struct alignas(64) Node {
    float bounds[3][2][width]; // axis; lower, upper; child
    Child children[width];
};
static_assert(sizeof(Node) == 448);

// Up to sixteen triangles. Unused places are NaN, which fails every comparison.
struct alignas(64) Block {
    float positions[3][3][width]; // axis, corner, triangle
    uint32_t primitives[width];
};
static_assert(sizeof(Block) == 640);

inline constexpr Child nodeStride = sizeof(Node) / childUnit, blockStride = sizeof(Block) / childUnit;

// No path from the root may have more nodes: traversals keep a stack for it.
inline constexpr int maxDepth = 96;

// What a traversal reads. Without nodes, all blocks are tested: where there are few, that is faster.
struct View {
    const Node* nodes; // the root first
    const Block* blocks;
    uint32_t numNodes, numBlocks;
    alignas(16) float middle[4]; // of the box around all triangles
    float margin; // the part of the boxes' margin that is the same for all rays
};

// Rays that are traced together, at most: a word has a bit for each.
inline constexpr unsigned mostRays = 64;

struct Hit {
    static constexpr uint32_t none = ~uint32_t { 0 };

    float t; // in units of |direction|
    uint32_t primitive; // index into the triangles that the tree was made of
    float u, v; // weights of the second and the third corner
};

struct Counters {
    uint64_t nodes = 0, blocks = 0; // that rays were tested against
};

}
