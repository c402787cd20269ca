#pragma once
#include "bvh.h"
#include "draw.h"
#include "interpolate.h"
#include "intersect.h"
#include "render.h"
#include "scene.h"
#include "texture.h"
#include <stack>
#include <vector>

glm::vec3 hsvToRgb(float h)
{
    return glm::vec3(1.f, 1.f - h, 0.f);
}

void updateHitInfo(RenderState& state, const BVHInterface::Primitive& primitive, const Ray& ray, HitInfo& hitInfo)
{
    const auto& [v0, v1, v2] = std::tie(primitive.v0, primitive.v1, primitive.v2);
    const auto& mesh = state.scene.meshes[primitive.meshID];
    const auto n = glm::normalize(glm::cross(v1.position - v0.position, v2.position - v0.position));
    const auto p = ray.origin + ray.t * ray.direction;
    hitInfo.material = mesh.material;
    hitInfo.normal = n;
    hitInfo.barycentricCoord = computeBarycentricCoord(v0.position, v1.position, v2.position, p);
    if (state.features.enableNormalInterp) {
        hitInfo.normal = interpolateNormal(v0.normal, v1.normal, v2.normal, hitInfo.barycentricCoord);
    }
    hitInfo.texCoord = interpolateTexCoord(v0.texCoord, v1.texCoord, v2.texCoord, hitInfo.barycentricCoord);
    if (glm::dot(ray.direction, hitInfo.normal) > 0.0f) {
        hitInfo.normal = -hitInfo.normal;
    }
}

bool BVH::intersect(RenderState& state, Ray& ray, HitInfo& hitInfo) const
{
    if (!state.features.enableAccelStructure) {
        return intersectRayWithBVH(state, *this, ray, hitInfo);
    }
    std::stack<std::pair<int, BVHInterface::Node>> stack;
    stack.push({ 0, m_nodes[RootIndex] });
    std::vector<std::pair<int, Node>> visited;
    bool is_hit = false;
    HitInfo dummy;
    while (!stack.empty()) {
        BVHInterface::Node node = stack.top().second;
        int level = stack.top().first;
        stack.pop();
        float t = ray.t;
        bool inBox = intersectRayWithShape(node.aabb, ray);
        ray.t = t;
        if (!inBox)
            continue;
        if (state.features.enableDebugDraw)
            visited.push_back({ level, node });
        if (node.isLeaf()) {
            for (int i = 0; i < node.primitiveCount(); i++) {
                Primitive triangle = m_primitives[node.primitiveOffset() + i];
                const auto& [v0, v1, v2] = std::tie(triangle.v0, triangle.v1, triangle.v2);
                if (intersectRayWithTriangle(v0.position, v1.position, v2.position, ray, dummy)) {
                    updateHitInfo(state, triangle, ray, hitInfo);
                    is_hit = true;
                }
            }
        } else {
            stack.push({ level + 1, m_nodes[node.leftChild()] });
            stack.push({ level + 1, m_nodes[node.rightChild()] });
        }
    }
    for (int i = 0; i < visited.size(); i++)
        drawAABB(visited[i].second.aabb, DrawMode::Wireframe, hsvToRgb(float(i) / m_numLevels));
    for (const auto& sphere : state.scene.spheres)
        is_hit |= intersectRayWithShape(sphere, ray, hitInfo);
    return is_hit;
}
