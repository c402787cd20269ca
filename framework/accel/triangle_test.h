#pragma once
#include <framework/ray.h>
#include <glm/geometric.hpp>

namespace accel {

struct TriangleHit {
    float t; // in units of |direction|
    glm::vec3 barycentric; // unnormalised: divide by the sum
    glm::vec3 normal; // unnormalised, on the side of counter-clockwise v0, v1, v2
};

// Whether the ray meets the triangle at a distance in [0, ray.t]; edges belong to it, both sides count.
// Signed volumes decide which side of an edge the ray passes: two triangles that share the edge compute the same
// number with opposite sign, so no ray slips between them. Kensler and Shirley 2006, "Optimizing Ray-Triangle
// Intersection via Automated Search", section 2.
[[nodiscard]] inline bool testTriangle(
    const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2, const Ray& ray, TriangleHit& hit)
{
    const glm::vec3 a = v0 - ray.origin;
    const glm::vec3 b = v1 - ray.origin;
    const glm::vec3 c = v2 - ray.origin;
    const float alpha = glm::dot(ray.direction, glm::cross(c, b));
    const float beta = glm::dot(ray.direction, glm::cross(a, c));
    const float gamma = glm::dot(ray.direction, glm::cross(b, a));
    const bool anyNegative = (alpha < 0.0f) | (beta < 0.0f) | (gamma < 0.0f);
    const bool anyPositive = (alpha > 0.0f) | (beta > 0.0f) | (gamma > 0.0f);
    if (anyNegative == anyPositive) // outside, or edge-on
        return false;

    // The distance from the plane's equation: a weighted sum of the corners loses digits on huge triangles.
    const glm::vec3 normal = glm::cross(v1 - v0, v2 - v0);
    const float t = glm::dot(normal, a) / glm::dot(normal, ray.direction);
    if (!(t >= 0.0f && t <= ray.t)) // NaN fails too
        return false;
    hit = { t, { alpha, beta, gamma }, normal };
    return true;
}

}
