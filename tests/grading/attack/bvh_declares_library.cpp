// refused: declares by hand what no header of the interface offers
#include "bvh.h"
#include "render.h"

namespace accel {
struct TriangleHit {
    float room[16];
};
const BVHInterface::Primitive* findClosest(const BVHInterface& bvh, Ray& ray, TriangleHit& hit);
}

bool BVH::intersect(RenderState&, Ray& ray, HitInfo&) const
{
    accel::TriangleHit hit;
    return accel::findClosest(*this, ray, hit) != nullptr;
}
