#pragma once
#include "bvh.h"
#include "grading/random.h"
#include "render.h"
#include "scene.h"
#include <array>

namespace tests {

// A scene with all that the functions of the renderer want to be given.
struct World {
    explicit World(Scene scene_ = {}, const Features& features_ = {})
        : scene(std::move(scene_))
        , features(features_)
        , bvh(scene, features)
    {
    }
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    const Scene scene;
    Features features;
    BVH bvh;
    RenderState state { scene, features, bvh, Sampler(1) };
};

// A parallelogram of two triangles, from a corner along two edges, which face the side of cross(edge01, edge02).
inline void addParallelogram(
    Scene& scene, const Material& material, const glm::vec3& v0, const glm::vec3& edge01, const glm::vec3& edge02)
{
    const glm::vec3 normal = glm::normalize(glm::cross(edge01, edge02));
    scene.meshes.push_back({ { { v0, normal, { 0, 0 } }, { v0 + edge01, normal, { 1, 0 } },
                                 { v0 + edge01 + edge02, normal, { 1, 1 } }, { v0 + edge02, normal, { 0, 1 } } },
        { { 0, 1, 2 }, { 0, 2, 3 } }, material });
}

// A square of side 20 around (0, 0, z), across the z axis.
inline void addPane(Scene& scene, const Material& material, float z)
{
    addParallelogram(scene, material, { -10, -10, z }, { 20, 0, 0 }, { 0, 20, 0 });
}

// A few roundings of numbers of about 1.
inline constexpr double fewRoundings = 1e-6;

inline double distance(const glm::vec3& a, const glm::dvec3& b)
{
    return glm::distance(glm::dvec3(a), b);
}

inline bool isFinite(const glm::vec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}
