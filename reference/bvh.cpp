#include "bvh.h"
#include "draw.h"
#include "interpolate.h"
#include "intersect.h"
#include "scene.h"
#include <array>

using Node = BVHInterface::Node;
using Primitive = BVHInterface::Primitive;

constexpr float missed = std::numeric_limits<float>::infinity();

// The distance at which the ray enters the box, 0 from inside; `missed` if that is not within [0, ray.t]. The slab
// method: Kay and Kajiya 1986. inverseDirection: 1 / ray.direction, positive infinity along axes that the ray does not
// move on.
static inline float intersectRayWithAABB(const AxisAlignedBox& box, const Ray& ray, const glm::vec3& inverseDirection)
{
    constexpr float rounding = 1.0f + 4.0f * std::numeric_limits<float>::epsilon(); // of a slab's distance, outwards
    const glm::vec3 toLower = (box.lower - ray.origin) * inverseDirection;
    const glm::vec3 toUpper = (box.upper - ray.origin) * inverseDirection;
    // A ray along a face gives 0 * infinity. In this order of the operands NaN loses every comparison, and the face
    // belongs to the box: min(x, y) is y < x ? y : x.
    const glm::vec3 in = glm::min(toLower, toUpper);
    const glm::vec3 out = glm::max(toUpper, toLower);
    const float entry = std::max(std::max(std::max(0.0f, in.x), in.y), in.z);
    const float exit = std::min(std::min(std::min(std::numeric_limits<float>::max(), out.x), out.y), out.z);
    return entry <= std::min(ray.t, exit * rounding) ? entry : missed;
}

static glm::vec3 intersectionPointRayWithAABB(const Ray& ray, float entry)
{
    return ray.origin + entry * ray.direction;
}

// The closest of a leaf's primitives that the ray meets, null if none; shortens the ray to it.
static const Primitive* intersectRayWithLeaf(std::span<const Primitive> primitives, Ray& ray)
{
    HitInfo unused; // filled once, for the closest hit of all
    const Primitive* closest = nullptr;
    for (const Primitive& p : primitives) {
        if (intersectRayWithTriangle(p.v0.position, p.v1.position, p.v2.position, ray, unused))
            closest = &p;
    }
    return closest;
}

// Walks the tree front to back, the nearer child first; tells onVisit(node, entry) of every node that it enters.
// Returns the closest primitive that the ray meets, null if none, and shortens the ray to it.
template <typename OnVisit> static const Primitive* traverse(const BVHInterface& bvh, Ray& ray, const OnVisit& onVisit)
{
    struct Visit {
        const Node* node;
        float entry;
    };
    const auto nodes = bvh.nodes();
    const auto primitives = bvh.primitives();
    const glm::vec3 inverseDirection = 1.0f / (ray.direction + 0.0f); // -0 + 0 is +0
    const auto enter = [&](uint32_t node) {
        return Visit { &nodes[node], intersectRayWithAABB(nodes[node].aabb, ray, inverseDirection) };
    };

    std::array<Visit, 64> postponed; // at most one sibling a level, and the builder stops at 64 levels
    std::size_t numPostponed = 0;
    const Primitive* closest = nullptr;
    for (Visit visit = enter(BVH::RootIndex);;) {
        if (visit.entry <= ray.t) { // otherwise missed, or something nearer was found meanwhile
            onVisit(*visit.node, visit.entry);
            if (!visit.node->isLeaf()) {
                Visit nearer = enter(visit.node->leftChild());
                Visit farther = enter(visit.node->rightChild());
                if (farther.entry < nearer.entry)
                    std::swap(nearer, farther);
                if (farther.entry != missed)
                    postponed[numPostponed++] = farther;
                visit = nearer;
                continue;
            }
            const auto leaf = primitives.subspan(visit.node->primitiveOffset(), visit.node->primitiveCount());
            if (const Primitive* closer = intersectRayWithLeaf(leaf, ray))
                closest = closer;
        }
        if (numPostponed == 0)
            return closest;
        visit = postponed[--numPostponed];
    }
}

// How many boxes a search for the closest hit enters.
static uint32_t countIntersectedAABBs(const BVHInterface& bvh, Ray ray)
{
    uint32_t count = 0;
    traverse(bvh, ray, [&](const Node&, float) { ++count; });
    return count;
}

// Draws the boxes in the order visited, from yellow to red, where the ray enters each, and the triangle that was hit.
static void drawTraversal(const BVHInterface& bvh, Ray ray)
{
    const float last = static_cast<float>(std::max(countIntersectedAABBs(bvh, ray), 2u) - 1u);
    float visited = 0.0f;
    const Primitive* closest = traverse(bvh, ray, [&](const Node& node, float entry) {
        const glm::vec3 color { 1.0f, 1.0f - visited++ / last, 0.0f };
        drawAABB(node.aabb, DrawMode::Wireframe, color);
        drawSphere(intersectionPointRayWithAABB(ray, entry), 0.005f, color);
    });
    if (closest)
        drawTriangle(closest->v0, closest->v1, closest->v2);
}

// Describes the hit of a primitive at ray.t.
static void updateHitInfo(const RenderState& state, const Primitive& primitive, const Ray& ray, HitInfo& hitInfo)
{
    const auto& [meshID, v0, v1, v2] = primitive;
    const glm::vec3 point = ray.origin + ray.t * ray.direction;
    const glm::vec3 bc = computeBarycentricCoord(v0.position, v1.position, v2.position, point);
    hitInfo.material = state.scene.meshes[meshID].material;
    hitInfo.barycentricCoord = bc;
    hitInfo.texCoord = interpolateTexCoord(v0.texCoord, v1.texCoord, v2.texCoord, bc);
    hitInfo.normal = state.features.enableNormalInterp
        ? interpolateNormal(v0.normal, v1.normal, v2.normal, bc)
        : glm::normalize(glm::cross(v1.position - v0.position, v2.position - v0.position));
    if (glm::dot(ray.direction, hitInfo.normal) > 0.0f)
        hitInfo.normal = -hitInfo.normal;
}

static bool intersectRayWithBVHImplemented(RenderState& state, const BVHInterface& bvh, Ray& ray, HitInfo& hitInfo)
{
    if (state.features.enableDebugDraw)
        drawTraversal(bvh, ray);
    const Primitive* closest = traverse(bvh, ray, [](const Node&, float) {});
    if (closest)
        updateHitInfo(state, *closest, ray, hitInfo);
    bool hitSphere = false;
    for (const Sphere& sphere : state.scene.spheres)
        hitSphere |= intersectRayWithShape(sphere, ray, hitInfo);
    return closest || hitSphere;
}

bool BVH::intersect(RenderState& state, Ray& ray, HitInfo& hitInfo) const
{
    if (!state.features.enableAccelStructure)
        return intersectRayWithBVH(state, *this, ray, hitInfo);
    return intersectRayWithBVHImplemented(state, *this, ray, hitInfo);
}
