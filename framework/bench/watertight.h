#pragma once
#include <cstddef>

namespace bench {

// Sends rays from inside closed meshes at their corners and at points of their edges, meshes of several sizes and far
// from the origin among them, and prints how many each rival lets through.
void measureLeaks(std::size_t numRays);

}
