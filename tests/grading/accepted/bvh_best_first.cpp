#include "bvh.h"
#include "interpolate.h"
#include "intersect.h"
#include "scene.h"
#include <optional>
#include <queue>

namespace {

struct Candidate {
    float distance;
    uint32_t node;
    bool operator<(const Candidate& other) const { return distance > other.distance; } // the nearest on top
};

std::optional<float> distanceToBox(const AxisAlignedBox& box, Ray ray)
{
    if (!intersectRayWithShape(box, ray))
        return std::nullopt;
    return ray.t;
}

glm::vec3 barycentric(const BVHInterface::Primitive& p, const glm::vec3& point)
{
    const glm::vec3 a = p.v0.position, b = p.v1.position, c = p.v2.position;
    const glm::vec3 normal = glm::cross(b - a, c - a);
    const float area = glm::dot(normal, normal);
    const float alpha = glm::dot(normal, glm::cross(c - b, point - b)) / area;
    const float beta = glm::dot(normal, glm::cross(a - c, point - c)) / area;
    return { alpha, beta, 1.0f - alpha - beta };
}

}

bool BVH::intersect(RenderState& state, Ray& ray, HitInfo& hitInfo) const
{
    if (!state.features.enableAccelStructure)
        return intersectRayWithBVH(state, *this, ray, hitInfo);

    std::optional<Primitive> closest;
    std::priority_queue<Candidate> candidates;
    const auto consider = [&](uint32_t node) {
        if (const auto distance = distanceToBox(m_nodes[node].aabb, ray))
            candidates.push({ *distance, node });
    };
    consider(RootIndex);
    while (!candidates.empty() && candidates.top().distance <= ray.t) {
        const Node& node = m_nodes[candidates.top().node];
        candidates.pop();
        if (!node.isLeaf()) {
            consider(node.leftChild());
            consider(node.rightChild());
            continue;
        }
        for (const Primitive& p : primitives().subspan(node.primitiveOffset(), node.primitiveCount()))
            if (intersectRayWithTriangle(p.v0.position, p.v1.position, p.v2.position, ray, hitInfo))
                closest = p; // and hitInfo.normal is its flat normal
    }
    if (closest) {
        const glm::vec3 bc = barycentric(*closest, ray.origin + ray.t * ray.direction);
        hitInfo.barycentricCoord = bc;
        hitInfo.texCoord = interpolateTexCoord(closest->v0.texCoord, closest->v1.texCoord, closest->v2.texCoord, bc);
        hitInfo.material = state.scene.meshes[closest->meshID].material;
        if (state.features.enableNormalInterp) {
            const glm::vec3 smooth = interpolateNormal(closest->v0.normal, closest->v1.normal, closest->v2.normal, bc);
            hitInfo.normal = glm::faceforward(smooth, ray.direction, smooth);
        }
    }
    bool isHit = closest.has_value();
    for (const Sphere& sphere : state.scene.spheres)
        isHit = intersectRayWithShape(sphere, ray, hitInfo) || isHit;
    return isHit;
}
