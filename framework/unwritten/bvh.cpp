#include "bvh.h"

// Says nothing: in the 2023-24 edition intersectRayWithBVH is the student's function, and this is all that is left to
// do.
[[gnu::weak]] bool BVH::intersect(RenderState& state, Ray& ray, HitInfo& hitInfo) const
{
    return intersectRayWithBVH(state, *this, ray, hitInfo);
}
