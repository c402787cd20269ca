#pragma once
#include "accel/wide/triangles.h"
#include <span>

namespace accel::wide {

// A plane through space: references across it are cut in two. Stich, Friedrich, Dietrich 2009, "Spatial Splits in
// Bounding Volume Hierarchies".
struct SpatialSplit {
    float cost = std::numeric_limits<float>::infinity(); // half areas times references of both sides
    int axis = -1; // none
    float position = 0.0f;
    uint32_t numCut = 0; // references that it makes two of, at most
};

// The best split that cuts at most maxCut references, none if there is none with something on both sides.
[[nodiscard]] SpatialSplit findSpatialSplit(
    std::span<const Reference> references, const Box& bounds, const Triangles& triangles, uint32_t maxCut);

}
