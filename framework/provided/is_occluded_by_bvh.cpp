#include "accel/traversal.h"
#include "accel/wide/tree.h"
#include "bvh.h"
#include "intersect.h"
#include "scene.h"

static bool isOccludedByTriangle(const BVHInterface& bvh, Ray ray)
{
    if (const accel::WideTree* tree = bvh.wideTree())
        return tree->occluded(ray);
    accel::TriangleHit unused;
    return accel::findClosest(bvh, ray, unused);
}

bool isOccludedByBVH(RenderState& state, const BVHInterface& bvh, const Ray& ray)
{
    if (state.needs.triangles && isOccludedByTriangle(bvh, ray))
        return true;
    HitInfo unused;
    return std::ranges::any_of(state.scene.spheres, [&](const Sphere& sphere) {
        Ray shortened = ray;
        return intersectRayWithShape(sphere, shortened, unused);
    });
}
