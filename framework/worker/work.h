#pragma once
#include "accel/ray_counts.h"
#include "worker/message.h"

namespace worker {

// What was done for a picture, or for some of its pixels.
struct Work {
    accel::RayCounts rays;
    uint64_t numNodes = 0, numTriangles = 0; // of the tree that everybody sees, by the library's traversal
    uint64_t numLookups = 0; // of textures

    Work& operator+=(const Work& other)
    {
        rays += other.rays;
        numNodes += other.numNodes;
        numTriangles += other.numTriangles;
        numLookups += other.numLookups;
        return *this;
    }
};

}
