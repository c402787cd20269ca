// refused: declares by hand and weakly, so that it is linked only where somebody else wants it, and has that done
#include "bvh.h"
#include "intersect.h"
#include "render.h"

namespace accel {
struct TriangleHit {
    float room[16];
};
[[gnu::weak]] const BVHInterface::Primitive* findClosest(const BVHInterface& bvh, Ray& ray, TriangleHit& hit);
}

bool BVH::intersect(RenderState& state, Ray& ray, HitInfo& hitInfo) const
{
    accel::TriangleHit hit;
    if (accel::findClosest)
        return accel::findClosest(*this, ray, hit) != nullptr;
    return intersectRayWithBVH(state, *this, ray, hitInfo);
}
