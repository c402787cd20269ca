#pragma once
#include "common.h"
#include "scene.h"
#include <array>

// Parallel panes above each other, through all of which a ray goes. Places are relative to the stack: width, depth and
// height.
namespace stress {

struct Pane {
    float height = 0.0f;
    glm::vec3 kd { 0.5f }, ks { 0.0f };
    float transparency = 1.0f;
};

struct Stack {
    static constexpr std::size_t most = 64;

    glm::vec3 center { 0.0f };
    glm::vec3 right { 1.0f, 0.0f, 0.0f }, away { 0.0f, 1.0f, 0.0f }, up { 0.0f, 0.0f, 1.0f }; // as long as a unit is
    float halfWidth = 8.0f;
    std::array<Pane, most> panes {};
    uint32_t count = 0; // of panes, lowest first

    void add(const Pane& pane) { panes[count++] = pane; }
};

[[nodiscard]] inline glm::vec3 placeIn(const Stack& stack, const glm::vec3& place)
{
    const glm::dvec3 p(place);
    return glm::vec3(glm::dvec3(stack.center) + p.x * glm::dvec3(stack.right) + p.y * glm::dvec3(stack.away)
        + p.z * glm::dvec3(stack.up));
}

// From one place to another: t is the distance.
[[nodiscard]] inline Ray rayIn(const Stack& stack, const glm::vec3& from, const glm::vec3& to)
{
    const glm::vec3 origin = placeIn(stack, from);
    const glm::vec3 way = placeIn(stack, to) - origin;
    const float distance = glm::length(way);
    return { origin, way / distance, distance };
}

[[nodiscard]] inline Mesh meshOf(const Stack& stack, const Pane& pane)
{
    const float w = stack.halfWidth;
    Mesh mesh;
    for (const glm::vec2 corner : { glm::vec2(-w, -w), glm::vec2(w, -w), glm::vec2(w, w), glm::vec2(-w, w) })
        mesh.vertices.push_back({ placeIn(stack, { corner, pane.height }), glm::normalize(stack.up), {} });
    mesh.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
    mesh.material = { .kd = pane.kd, .ks = pane.ks, .transparency = pane.transparency };
    return mesh;
}

[[nodiscard]] inline Scene sceneOf(const Stack& stack)
{
    Scene scene;
    for (uint32_t i = 0; i < stack.count; ++i)
        scene.meshes.push_back(meshOf(stack, stack.panes[i]));
    return scene;
}

}
