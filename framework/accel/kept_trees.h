#pragma once
#include "files/kept_arrays.h"

namespace accel {

// From now on this process keeps the trees of large scenes there from one run to the next; else nowhere. Before any
// tree is built.
void keepTreesIn(const std::filesystem::path& folder);

// Where the tree of so many triangles is kept; null if it is not.
[[nodiscard]] const files::KeptArrays* keptTrees(std::size_t numTriangles);

}
