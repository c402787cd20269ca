#include "bvh.h"
#include "draw.h"
#include "interpolate.h"
#include "intersect.h"
#include "scene.h"

static void updateHitInfo(RenderState& state, const BVHInterface::Primitive& p, const Ray& ray, HitInfo& hitInfo)
{
    const glm::vec3 point = ray.origin + ray.t * ray.direction;
    hitInfo.barycentricCoord = computeBarycentricCoord(p.v0.position, p.v1.position, p.v2.position, point);
    hitInfo.texCoord = interpolateTexCoord(p.v0.texCoord, p.v1.texCoord, p.v2.texCoord, hitInfo.barycentricCoord);
    hitInfo.material = state.scene.meshes[p.meshID].material;
    if (state.features.enableNormalInterp)
        hitInfo.normal = interpolateNormal(p.v0.normal, p.v1.normal, p.v2.normal, hitInfo.barycentricCoord);
    if (glm::dot(hitInfo.normal, ray.direction) > 0)
        hitInfo.normal = -hitInfo.normal;
}

static bool intersectBox(const AxisAlignedBox& box, Ray& ray)
{
    const float before = ray.t;
    const bool isHit = intersectRayWithShape(box, ray);
    ray.t = before;
    return isHit;
}

static bool intersectNode(
    RenderState& state, const BVHInterface& bvh, const BVHInterface::Node& node, Ray& ray, HitInfo& hitInfo)
{
    if (!intersectBox(node.aabb, ray))
        return false;
    if (state.features.enableDebugDraw)
        drawAABB(node.aabb, DrawMode::Wireframe, glm::vec3(1, 1, 0), 1.0f);
    bool hit = false;
    if (node.isLeaf()) {
        for (uint32_t i = node.primitiveOffset(); i < node.primitiveOffset() + node.primitiveCount(); ++i) {
            const BVHInterface::Primitive primitive = bvh.primitives()[i];
            if (intersectRayWithTriangle(
                    primitive.v0.position, primitive.v1.position, primitive.v2.position, ray, hitInfo)) {
                updateHitInfo(state, primitive, ray, hitInfo);
                hit = true;
            }
        }
        return hit;
    }
    hit = intersectNode(state, bvh, bvh.nodes()[node.leftChild()], ray, hitInfo);
    if (intersectNode(state, bvh, bvh.nodes()[node.rightChild()], ray, hitInfo))
        hit = true;
    return hit;
}

bool BVH::intersect(RenderState& state, Ray& ray, HitInfo& hitInfo) const
{
    if (!state.features.enableAccelStructure)
        return intersectRayWithBVH(state, *this, ray, hitInfo);
    bool hit = intersectNode(state, *this, m_nodes[RootIndex], ray, hitInfo);
    for (const auto& sphere : state.scene.spheres)
        if (intersectRayWithShape(sphere, ray, hitInfo))
            hit = true;
    return hit;
}
