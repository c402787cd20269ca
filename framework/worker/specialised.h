#pragma once
#include "fwd.h"
#include <framework/trackball.h>

namespace accel {
class WideTree;
}

namespace worker {

// Renders what renderImage does with the reference and the library's tree, to the bit, by code that was compiled for
// what the scene needs alone: nothing in it can be replaced, so all of it is one function to the compiler. What leaving
// out can reach at best. Of random numbers it knows the independent ones only, and none of the extensions.
void renderSpecialised(
    const Scene& scene, const BVH& bvh, const Features& features, const Trackball& camera, Screen& screen);

}
