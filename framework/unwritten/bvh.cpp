#include "bvh.h"
#include "not_written_yet.h"

// Weak like its neighbours. BVH's table of virtual functions stands wherever this one is defined.
[[gnu::weak]] bool BVH::intersect(RenderState& state, Ray& ray, HitInfo& hitInfo) const
{
    notWrittenYet("BVH::intersect");
    return intersectRayWithBVH(state, *this, ray, hitInfo);
}
