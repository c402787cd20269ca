#pragma once
#include "accel/wide/box.h"
#include "accel/wide/node.h"
#include <algorithm>

namespace accel::wide {

[[nodiscard]] inline Node emptyNode()
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    Node node;
    for (auto& axis : node.bounds) {
        std::ranges::fill(axis[0], infinity);
        std::ranges::fill(axis[1], -infinity);
    }
    std::ranges::fill(node.children, Child { 0 });
    return node;
}

inline void setBox(Node& node, std::size_t i, const Box& box)
{
    for (int axis = 0; axis < 3; ++axis) {
        node.bounds[axis][0][i] = box.lower[axis];
        node.bounds[axis][1][i] = box.upper[axis];
    }
}

}
