#pragma once
#include "accel/triangle_test.h"
#include "bvh_interface.h"

namespace accel {

// The closest triangle of the tree that the ray meets at a distance in [0, ray.t], null if none; ray.t and hit are
// changed only by a hit.
[[nodiscard]] const BVHInterface::Primitive* findClosest(const BVHInterface& bvh, Ray& ray, TriangleHit& hit);

}
