#include "bvh.h"
#include "draw.h"
#include "interpolate.h"
#include "intersect.h"
#include "scene.h"
#include <array>

using Node = BVHInterface::Node;
using Primitive = BVHInterface::Primitive;

// Where the ray is inside the box, within [0, ray.t]; empty if it misses. The slab method: Kay and Kajiya 1986.
struct Interval {
    float entry, exit;
    [[nodiscard]] bool isEmpty() const { return !(entry <= exit); }
};

static Interval intersectRayWithAABB(const AxisAlignedBox& box, const Ray& ray, const glm::vec3& inverseDirection)
{
    constexpr float rounding = 1.0f + 4.0f * std::numeric_limits<float>::epsilon(); // of a slab's distance, outwards
    Interval inside { 0.0f, ray.t };
    for (int axis = 0; axis < 3; ++axis) {
        const float toLower = (box.lower[axis] - ray.origin[axis]) * inverseDirection[axis];
        const float toUpper = (box.upper[axis] - ray.origin[axis]) * inverseDirection[axis];
        const bool forwards = inverseDirection[axis] >= 0.0f;
        const float entry = forwards ? toLower : toUpper;
        const float exit = (forwards ? toUpper : toLower) * rounding;
        // A ray along a face gives 0 * infinity: NaN loses both comparisons, so that the face belongs to the box.
        inside.entry = entry > inside.entry ? entry : inside.entry;
        inside.exit = exit < inside.exit ? exit : inside.exit;
    }
    return inside;
}

static glm::vec3 intersectionPointRayWithAABB(const Ray& ray, const Interval& inside)
{
    return ray.origin + inside.entry * ray.direction;
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

// Walks the tree front to back, the nearer child first; tells onVisit(node, interval) of every node that it enters.
// Returns the closest primitive that the ray meets, null if none, and shortens the ray to it.
template <typename OnVisit> static const Primitive* traverse(const BVHInterface& bvh, Ray& ray, const OnVisit& onVisit)
{
    struct Entry {
        const Node* node;
        Interval inside;
    };
    const auto nodes = bvh.nodes();
    const auto primitives = bvh.primitives();
    const glm::vec3 inverseDirection = 1.0f / ray.direction;
    const auto enter = [&](uint32_t node) {
        return Entry { &nodes[node], intersectRayWithAABB(nodes[node].aabb, ray, inverseDirection) };
    };

    std::array<Entry, 64> stack; // a level leaves at most one node behind, and the builder stops at 64 levels
    std::size_t stackSize = 0;
    const auto push = [&](const Entry& entry) {
        if (!entry.inside.isEmpty())
            stack[stackSize++] = entry;
    };

    const Primitive* closest = nullptr;
    push(enter(BVH::RootIndex));
    while (stackSize > 0) {
        const auto [node, inside] = stack[--stackSize];
        if (inside.entry > ray.t) // something nearer was found meanwhile
            continue;
        onVisit(*node, inside);
        if (node->isLeaf()) {
            if (const Primitive* closer
                = intersectRayWithLeaf(primitives.subspan(node->primitiveOffset(), node->primitiveCount()), ray))
                closest = closer;
            continue;
        }
        Entry near = enter(node->leftChild());
        Entry far = enter(node->rightChild());
        if (far.inside.entry < near.inside.entry)
            std::swap(near, far);
        push(far);
        push(near);
    }
    return closest;
}

// How many boxes a search for the closest hit enters.
static uint32_t countIntersectedAABBs(const BVHInterface& bvh, Ray ray)
{
    uint32_t count = 0;
    traverse(bvh, ray, [&](const Node&, const Interval&) { ++count; });
    return count;
}

// Draws the boxes in the order visited, from yellow to red, where the ray enters each, and the triangle that was hit.
static void drawTraversal(const BVHInterface& bvh, Ray ray)
{
    const float last = static_cast<float>(std::max(countIntersectedAABBs(bvh, ray), 2u) - 1u);
    float visited = 0.0f;
    const Primitive* closest = traverse(bvh, ray, [&](const Node& node, const Interval& inside) {
        const glm::vec3 color { 1.0f, 1.0f - visited++ / last, 0.0f };
        drawAABB(node.aabb, DrawMode::Wireframe, color);
        drawSphere(intersectionPointRayWithAABB(ray, inside), 0.005f, color);
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
    const Primitive* closest = traverse(bvh, ray, [](const Node&, const Interval&) {});
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
