#pragma once
#include <cstdint>

namespace report {

// What the probe figures.tree answers of a RenderRequest: the tree as the submission builds and counts it.
struct TreeFacts {
    uint64_t numTriangles = 0, numNodes = 0;
    uint32_t numLevels = 0, numLeaves = 0;
    double buildSeconds = 0.0;
};

}
