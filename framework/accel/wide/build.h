#pragma once
#include "accel/wide/collapse.h"

namespace accel::wide {

struct Built {
    WideNodes wide;
    Box box; // around all triangles; if there is nothing to meet, empty
};

// A tree by the surface area heuristic, cut in space where that pays. The same for any number of threads. Triangles
// with a coordinate that is not finite are left out.
[[nodiscard]] Built build(const Triangles& triangles);

}
