#pragma once
#include "bvh.h"
#include "render.h"
#include "scene.h"

namespace grading {

// A state for functions that are given one and need not look at it.
struct EmptyState {
    Scene scene;
    Features features;
    BVH bvh { scene, features };
    RenderState state { scene, features, bvh, Sampler(1) };
};

}
