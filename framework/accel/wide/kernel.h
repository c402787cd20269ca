#pragma once
#include "accel/wide/kernels.h"
#include "accel/wide/traverse.h"
#include "accel/wide/traverse_shaft.h"
#include "accel/wide/traverse_together.h"

namespace accel::wide {

// All traversals for one instruction set.
template <typename Simd> constexpr Kernel kernelOf(const char* name)
{
    using Alone = Traversal<Simd>;
    return { name, Alone::closest, Alone::closestCounted, TogetherTraversal<Simd>::closestOfEach, Alone::occluded,
        Alone::occludedCounted, ShaftTraversal<Simd>::isClear };
}

}
