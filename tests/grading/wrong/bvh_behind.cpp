#include "bvh.h"
#include "interpolate.h"
#include "intersect.h"
#include "scene.h"

// Moller and Trumbore's test, which forgets that t may be negative.
static bool hitTriangle(const BVHInterface::Primitive& p, const Ray& ray, float& t, glm::vec3& bc)
{
    const glm::vec3 e1 = p.v1.position - p.v0.position;
    const glm::vec3 e2 = p.v2.position - p.v0.position;
    const glm::vec3 h = glm::cross(ray.direction, e2);
    const float a = glm::dot(e1, h);
    if (a == 0.0f)
        return false;
    const glm::vec3 s = ray.origin - p.v0.position;
    const float u = glm::dot(s, h) / a;
    const glm::vec3 q = glm::cross(s, e1);
    const float v = glm::dot(ray.direction, q) / a;
    if (u < 0.0f || v < 0.0f || u + v > 1.0f)
        return false;
    t = glm::dot(e2, q) / a;
    bc = { 1.0f - u - v, u, v };
    return t <= ray.t;
}

static bool visit(RenderState& state, const BVHInterface& bvh, uint32_t index, Ray& ray, HitInfo& hitInfo)
{
    const BVHInterface::Node& node = bvh.nodes()[index];
    Ray toBox = ray;
    if (!intersectRayWithShape(node.aabb, toBox))
        return false;
    if (!node.isLeaf()) {
        const bool left = visit(state, bvh, node.leftChild(), ray, hitInfo);
        const bool right = visit(state, bvh, node.rightChild(), ray, hitInfo);
        return left || right;
    }
    bool isHit = false;
    for (uint32_t i = 0; i < node.primitiveCount(); i++) {
        const BVHInterface::Primitive& p = bvh.primitives()[node.primitiveOffset() + i];
        float t;
        glm::vec3 bc;
        if (!hitTriangle(p, ray, t, bc))
            continue;
        isHit = true;
        ray.t = t;
        hitInfo.barycentricCoord = bc;
        hitInfo.texCoord = interpolateTexCoord(p.v0.texCoord, p.v1.texCoord, p.v2.texCoord, bc);
        hitInfo.material = state.scene.meshes[p.meshID].material;
        hitInfo.normal = state.features.enableNormalInterp
            ? interpolateNormal(p.v0.normal, p.v1.normal, p.v2.normal, bc)
            : glm::normalize(glm::cross(p.v1.position - p.v0.position, p.v2.position - p.v0.position));
        if (glm::dot(hitInfo.normal, ray.direction) > 0.0f)
            hitInfo.normal = -hitInfo.normal;
    }
    return isHit;
}

bool BVH::intersect(RenderState& state, Ray& ray, HitInfo& hitInfo) const
{
    if (!state.features.enableAccelStructure)
        return intersectRayWithBVH(state, *this, ray, hitInfo);
    bool isHit = visit(state, *this, RootIndex, ray, hitInfo);
    for (const Sphere& sphere : state.scene.spheres)
        isHit |= intersectRayWithShape(sphere, ray, hitInfo);
    return isHit;
}
