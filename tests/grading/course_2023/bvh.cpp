#include "bvh.h"
#include "draw.h"
#include "extra.h"
#include "interpolate.h"
#include "intersect.h"
#include "render.h"
#include "scene.h"
#include "texture.h"
#include <algorithm>
#include <bit>
#include <chrono>
#include <framework/opengl_includes.h>
#include <iostream>
#include <stack>

void updateHitInfo(RenderState& state, const BVHInterface::Primitive& primitive, const Ray& ray, HitInfo& hitInfo)
{
    const auto& [v0, v1, v2] = std::tie(primitive.v0, primitive.v1, primitive.v2);
    const auto p = ray.origin + ray.t * ray.direction;
    hitInfo.material = state.scene.meshes[primitive.meshID].material;
    hitInfo.barycentricCoord = computeBarycentricCoord(v0.position, v1.position, v2.position, p);
    hitInfo.normal = glm::normalize(glm::cross(v1.position - v0.position, v2.position - v0.position));
    if (state.features.enableNormalInterp)
        hitInfo.normal = interpolateNormal(v0.normal, v1.normal, v2.normal, hitInfo.barycentricCoord);
    hitInfo.texCoord = interpolateTexCoord(v0.texCoord, v1.texCoord, v2.texCoord, hitInfo.barycentricCoord);
    if (glm::dot(ray.direction, hitInfo.normal) > 0.0f)
        hitInfo.normal = -hitInfo.normal;
}

BVH::BVH(const Scene& scene, const Features& features)
{
    std::vector<Primitive> primitives;
    for (uint32_t meshID = 0; meshID < scene.meshes.size(); meshID++) {
        const auto& mesh = scene.meshes[meshID];
        for (const auto& triangle : mesh.triangles) {
            primitives.push_back(Primitive { .meshID = meshID,
                .v0 = mesh.vertices[triangle.x],
                .v1 = mesh.vertices[triangle.y],
                .v2 = mesh.vertices[triangle.z] });
        }
    }
    m_nodes.emplace_back();
    m_nodes.emplace_back();
    buildRecursive(scene, features, primitives, RootIndex);
    buildNumLevels();
    buildNumLeaves();
}

uint32_t BVH::nextNodeIdx()
{
    const auto idx = static_cast<uint32_t>(m_nodes.size());
    m_nodes.emplace_back();
    return idx;
}

AxisAlignedBox computePrimitiveAABB(const BVHInterface::Primitive primitive)
{
    return { .lower = glm::min(glm::min(primitive.v0.position, primitive.v1.position), primitive.v2.position),
        .upper = glm::max(glm::max(primitive.v0.position, primitive.v1.position), primitive.v2.position) };
}

AxisAlignedBox computeSpanAABB(std::span<const BVHInterface::Primitive> primitives)
{
    glm::vec3 lower(std::numeric_limits<float>::max()), upper(-std::numeric_limits<float>::max());
    for (BVHInterface::Primitive p : primitives) {
        const AxisAlignedBox box = computePrimitiveAABB(p);
        lower = glm::min(lower, box.lower);
        upper = glm::max(upper, box.upper);
    }
    return { .lower = lower, .upper = upper };
}

glm::vec3 computePrimitiveCentroid(const BVHInterface::Primitive primitive)
{
    return (primitive.v0.position + primitive.v1.position + primitive.v2.position) / 3.0f;
}

uint32_t computeAABBLongestAxis(const AxisAlignedBox& aabb)
{
    const glm::vec3 size = aabb.upper - aabb.lower;
    if (size.x >= size.y && size.x >= size.z)
        return 0;
    return size.y >= size.z ? 1 : 2;
}

size_t splitPrimitivesByMedian(const AxisAlignedBox& aabb, uint32_t axis, std::span<BVHInterface::Primitive> primitives)
{
    using Primitive = BVHInterface::Primitive;
    std::sort(primitives.begin(), primitives.end(), [axis](const Primitive& a, const Primitive& b) {
        return computePrimitiveCentroid(a)[axis] < computePrimitiveCentroid(b)[axis];
    });
    return (primitives.size() + 1) / 2;
}

bool intersectRayWithBVH(RenderState& state, const BVHInterface& bvh, Ray& ray, HitInfo& hitInfo)
{
    std::span<const BVHInterface::Node> nodes = bvh.nodes();
    std::span<const BVHInterface::Primitive> primitives = bvh.primitives();
    bool is_hit = false;
    std::stack<uint32_t> stack;
    stack.push(BVH::RootIndex);
    while (!stack.empty()) {
        const auto& node = nodes[stack.top()];
        stack.pop();
        Ray copy = ray;
        if (!intersectRayWithShape(node.aabb, copy))
            continue;
        if (!node.isLeaf()) {
            stack.push(node.leftChild());
            stack.push(node.rightChild());
            continue;
        }
        for (const auto& p : primitives.subspan(node.primitiveOffset(), node.primitiveCount())) {
            if (intersectRayWithTriangle(p.v0.position, p.v1.position, p.v2.position, ray, hitInfo)) {
                updateHitInfo(state, p, ray, hitInfo);
                is_hit = true;
            }
        }
    }
    for (const auto& sphere : state.scene.spheres)
        is_hit |= intersectRayWithShape(sphere, ray, hitInfo);
    return is_hit;
}

BVH::Node BVH::buildLeafData(
    const Scene& scene, const Features& features, const AxisAlignedBox& aabb, std::span<Primitive> primitives)
{
    Node node;
    node.aabb = aabb;
    node.data = { Node::LeafBit | (uint32_t)m_primitives.size(), (uint32_t)primitives.size() };
    std::copy(primitives.begin(), primitives.end(), std::back_inserter(m_primitives));
    return node;
}

BVH::Node BVH::buildNodeData(const Scene& scene, const Features& features, const AxisAlignedBox& aabb,
    uint32_t leftChildIndex, uint32_t rightChildIndex)
{
    return Node { aabb, { leftChildIndex, rightChildIndex } };
}

void BVH::buildRecursive(
    const Scene& scene, const Features& features, std::span<Primitive> primitives, uint32_t nodeIndex)
{
    AxisAlignedBox aabb = computeSpanAABB(primitives);
    if (primitives.size() <= LeafSize) {
        m_nodes[nodeIndex] = buildLeafData(scene, features, aabb, primitives);
        return;
    }
    size_t split = splitPrimitivesByMedian(aabb, computeAABBLongestAxis(aabb), primitives);
    uint32_t left = nextNodeIdx();
    uint32_t right = nextNodeIdx();
    m_nodes[nodeIndex] = buildNodeData(scene, features, aabb, left, right);
    buildRecursive(scene, features, primitives.subspan(0, split), left);
    buildRecursive(scene, features, primitives.subspan(split), right);
}

void BVH::buildNumLevels()
{
    m_numLevels = 1;
}

void BVH::buildNumLeaves()
{
    m_numLeaves = 1;
}

void BVH::debugDrawLevel(int level)
{
    AxisAlignedBox aabb { .lower = glm::vec3(0.0f), .upper = glm::vec3(0.0f, 1.05f, 1.05f) };
    drawAABB(aabb, DrawMode::Wireframe, glm::vec3(0.05f, 1.0f, 0.05f), 0.1f);
}

void BVH::debugDrawLeaf(int leafIndex)
{
    drawAABB(m_nodes[0].aabb, DrawMode::Filled);
}
