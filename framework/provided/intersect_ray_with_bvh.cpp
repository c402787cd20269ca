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
    const glm::vec3& bc = hit.barycentric;
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

const BVHInterface::Primitive* findInBinaryTree(const BVHInterface& bvh, Ray& ray, accel::TriangleHit& hit)
{
    const BVHInterface::Primitive* found = accel::findClosest(bvh, ray, hit);
    const glm::vec3& volumes = hit.barycentric;
    if (found)
        hit.barycentric = volumes / (volumes.x + volumes.y + volumes.z);
    return found;
}

const BVHInterface::Primitive* findInWideTree(
    const accel::WideTree& tree, const BVHInterface& bvh, Ray& ray, accel::TriangleHit& hit)
{
    const auto found = tree.closest(ray);
    if (!found)
        return nullptr;
    const BVHInterface::Primitive& primitive = bvh.primitives()[found->primitive];
    const glm::vec3 &a = primitive.v0.position, &b = primitive.v1.position, &c = primitive.v2.position;
    hit = { found->t, { 1.0f - found->u - found->v, found->u, found->v }, glm::cross(b - a, c - a) };
    ray.t = found->t;
    return &primitive;
}

// In the library's own tree if there is one; in the one that everybody sees otherwise, and if somebody counts its
// nodes. The hit's weights have the sum 1.
const BVHInterface::Primitive* findTriangle(
    const RenderState& state, const BVHInterface& bvh, Ray& ray, accel::TriangleHit& hit)
{
    if (!state.needs.triangles)
        return nullptr;
    const accel::WideTree* tree = bvh.wideTree();
    return tree && !debug::Tally::isOpen() ? findInWideTree(*tree, bvh, ray, hit) : findInBinaryTree(bvh, ray, hit);
}

}

bool intersectRayWithBVH(RenderState& state, const BVHInterface& bvh, Ray& ray, HitInfo& hitInfo)
{
    accel::TriangleHit hit;
    const BVHInterface::Primitive* primitive = findTriangle(state, bvh, ray, hit);
    if (primitive)
        fillHit(state, *primitive, hit, ray, hitInfo);
    bool hitSphere = false;
    for (const Sphere& sphere : state.scene.spheres)
        hitSphere |= intersectRayWithShape(sphere, ray, hitInfo);
    return primitive || hitSphere;
}
