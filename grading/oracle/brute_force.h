#pragma once
#include "scene.h"
#include <framework/ray.h>

namespace grading {

// What a ray meets, in double precision, by trying all triangles and spheres.
struct SceneHit {
    bool isHit = false;
    bool isClear
        = true; // false where rounding may decide: ties, edges, grazing rays, a hit close to either end of the ray
    double t = 0.0; // in units of |direction|
    const Material* material = nullptr;

    const Mesh* mesh = nullptr; // null for a sphere, and then what follows is unset
    glm::uvec3 triangle { 0 };
    glm::dvec3 barycentric { 0.0 };
    glm::dvec3 normal { 0.0 }; // of the flat triangle, unit, on the side the ray came from
};

// The closest hit at a distance in [0, ray.t]; two-sided, edges included; a triangle without area is never met.
[[nodiscard]] SceneHit closestHit(const Scene& scene, const Ray& ray);

// Whether anything lies strictly between two points.
[[nodiscard]] bool isBlocked(const Scene& scene, const glm::dvec3& from, const glm::dvec3& to);

}
