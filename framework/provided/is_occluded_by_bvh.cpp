#include "accel/counting_bvh.h"
#include "accel/light_shaft.h"
#include "accel/sphere_test.h"
#include "accel/traversal.h"
#include "accel/wide/tree.h"
#include "bvh.h"
#include "scene.h"

static bool isOccludedByTriangle(const BVHInterface& bvh, const Ray& ray)
{
    if (const accel::WideTree* tree = bvh.wideTree())
        return tree->occluded(ray);
    Ray shortened = ray;
    accel::TriangleHit unused;
    return accel::findClosest(bvh, shortened, unused);
}

static bool isOccludedBySphere(const Scene& scene, const Ray& ray)
{
    for (const Sphere& sphere : scene.spheres)
        if (accel::meets(sphere, ray))
            return true;
    return false;
}

bool isOccludedByBVH(RenderState& state, const BVHInterface& bvh, const Ray& ray)
{
    if (state.shaft && state.shaft->isClearFor(state, bvh, ray)) {
        accel::CountingBVH::addClear();
        return false;
    }
    return (state.needs.triangles && isOccludedByTriangle(bvh, ray))
        || (state.needs.spheres && isOccludedBySphere(state.scene, ray));
}
