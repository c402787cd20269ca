#include "bvh.h"
#include "interpolate.h"
#include "intersect.h"
#include "scene.h"
#include <stack>

static void updateHitInfo(RenderState& state, const BVHInterface::Primitive& p, const Ray& ray, HitInfo& hitInfo)
{
    const glm::vec3 point = ray.origin + ray.t * ray.direction;
    hitInfo.barycentricCoord = computeBarycentricCoord(p.v0.position, p.v1.position, p.v2.position, point);
    hitInfo.texCoord = interpolateTexCoord(p.v0.texCoord, p.v1.texCoord, p.v2.texCoord, hitInfo.barycentricCoord);
    hitInfo.material = state.scene.meshes[p.meshID].material;
    if (state.features.enableNormalInterp)
        hitInfo.normal = interpolateNormal(p.v0.normal, p.v1.normal, p.v2.normal, hitInfo.barycentricCoord);
    else
        hitInfo.normal = glm::normalize(glm::cross(p.v1.position - p.v0.position, p.v2.position - p.v0.position));
    if (glm::dot(hitInfo.normal, ray.direction) > 0.0f)
        hitInfo.normal = -hitInfo.normal;
}

bool BVH::intersect(RenderState& state, Ray& ray, HitInfo& hitInfo) const
{
    if (!state.features.enableAccelStructure)
        return intersectRayWithBVH(state, *this, ray, hitInfo);
    bool isHit = false;
    Primitive tested;
    std::stack<uint32_t> stack;
    stack.push(RootIndex);
    while (!stack.empty()) {
        const Node& node = m_nodes[stack.top()];
        stack.pop();
        const float t = ray.t;
        const bool inBox = intersectRayWithShape(node.aabb, ray);
        ray.t = t;
        if (!inBox)
            continue;
        if (!node.isLeaf()) {
            stack.push(node.rightChild());
            stack.push(node.leftChild());
            continue;
        }
        for (uint32_t i = 0; i < node.primitiveCount(); i++) {
            tested = m_primitives[node.primitiveOffset() + i];
            if (intersectRayWithTriangle(tested.v0.position, tested.v1.position, tested.v2.position, ray, hitInfo))
                isHit = true;
        }
    }
    if (isHit)
        updateHitInfo(state, tested, ray, hitInfo);
    for (const Sphere& sphere : state.scene.spheres)
        isHit |= intersectRayWithShape(sphere, ray, hitInfo);
    return isHit;
}
