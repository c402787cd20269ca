#pragma once
#include "accel/wide/node.h"
#include "accel/wide/shaft.h"
#include <framework/ray.h>
#include <span>

namespace accel::wide {

// One compilation of the traversal.
struct Kernel {
    const char* name; // of the instruction set
    bool (*closest)(const View& tree, const Ray& ray, Hit& hit); // hit is written if there is one
    bool (*closestCounted)(const View& tree, const Ray& ray, Hit& hit, Counters& counters);
    // For up to mostRays; the primitive of no hit is none.
    void (*closestOfEach)(const View& tree, const Ray* rays, unsigned count, Hit* hits);
    bool (*occluded)(const View& tree, const Ray& ray);
    bool (*occludedCounted)(const View& tree, const Ray& ray, Counters& counters);
    bool (*isClear)(const View& tree, const Shaft& shaft); // if not, perhaps still
};

// Those that this processor can run, the fastest first; never empty.
[[nodiscard]] std::span<const Kernel* const> kernels();
[[nodiscard]] inline const Kernel& bestKernel()
{
    return *kernels().front();
}

}
