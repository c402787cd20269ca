#include "bvh.h"
#include "interpolate.h"
#include "intersect.h"
#include "scene.h"
#include <queue>

struct Found {
    const BVHInterface::Primitive* primitive = nullptr;
    glm::vec3 barycentric;
};

static bool entersBox(const AxisAlignedBox& box, const Ray& ray)
{
    float tIn = 0.0f;
    float tOut = ray.t;
    for (int axis = 0; axis < 3; axis++) {
        if (ray.direction[axis] == 0.0f) {
            if (ray.origin[axis] < box.lower[axis] || ray.origin[axis] > box.upper[axis])
                return false;
            continue;
        }
        float t0 = (box.lower[axis] - ray.origin[axis]) / ray.direction[axis];
        float t1 = (box.upper[axis] - ray.origin[axis]) / ray.direction[axis];
        if (t0 > t1)
            std::swap(t0, t1);
        tIn = std::max(tIn, t0);
        tOut = std::min(tOut, t1);
        if (tIn > tOut)
            return false;
    }
    return true;
}

// Moller, Trumbore 1997
static void intersectTriangle(const BVHInterface::Primitive& p, Ray& ray, Found& found)
{
    const glm::vec3 edge1 = p.v1.position - p.v0.position;
    const glm::vec3 edge2 = p.v2.position - p.v0.position;
    const glm::vec3 h = glm::cross(ray.direction, edge2);
    const float determinant = glm::dot(edge1, h);
    if (determinant == 0.0f)
        return;
    const glm::vec3 s = ray.origin - p.v0.position;
    const float u = glm::dot(s, h) / determinant;
    if (u < 0.0f || u > 1.0f)
        return;
    const glm::vec3 q = glm::cross(s, edge1);
    const float v = glm::dot(ray.direction, q) / determinant;
    if (v < 0.0f || u + v > 1.0f)
        return;
    const float t = glm::dot(edge2, q) / determinant;
    if (t < 0.0f || t > ray.t)
        return;
    ray.t = t;
    found = { &p, { 1.0f - u - v, u, v } };
}

static void describe(const RenderState& state, const Found& found, const Ray& ray, HitInfo& hitInfo)
{
    const auto& [v0, v1, v2] = std::tie(found.primitive->v0, found.primitive->v1, found.primitive->v2);
    const glm::vec3 flat = glm::normalize(glm::cross(v1.position - v0.position, v2.position - v0.position));
    const glm::vec3 smooth = interpolateNormal(v0.normal, v1.normal, v2.normal, found.barycentric);
    hitInfo.barycentricCoord = found.barycentric;
    hitInfo.texCoord = interpolateTexCoord(v0.texCoord, v1.texCoord, v2.texCoord, found.barycentric);
    hitInfo.normal = state.features.enableNormalInterp ? smooth : flat;
    hitInfo.normal *= glm::dot(hitInfo.normal, ray.direction) > 0.0f ? -1.0f : 1.0f;
    hitInfo.material = state.scene.meshes[found.primitive->meshID].material;
}

bool BVH::intersect(RenderState& state, Ray& ray, HitInfo& hitInfo) const
{
    if (!state.features.enableAccelStructure)
        return intersectRayWithBVH(state, *this, ray, hitInfo);
    Found found;
    std::queue<uint32_t> queue;
    queue.push(RootIndex);
    while (!queue.empty()) {
        const Node node = nodes()[queue.front()];
        queue.pop();
        if (!entersBox(node.aabb, ray))
            continue;
        if (node.isLeaf()) {
            for (uint32_t i = 0; i < node.primitiveCount(); i++)
                intersectTriangle(primitives()[node.primitiveOffset() + i], ray, found);
        } else {
            queue.push(node.leftChild());
            queue.push(node.rightChild());
        }
    }
    bool hit = found.primitive != nullptr;
    if (hit)
        describe(state, found, ray, hitInfo);
    for (const auto& sphere : state.scene.spheres)
        hit |= intersectRayWithShape(sphere, ray, hitInfo);
    return hit;
}
