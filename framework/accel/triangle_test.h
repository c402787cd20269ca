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
// number with opposite sign, so no ray slips between them. In double precision, so that also around a corner, where all
// of these numbers are small, they are those of one and the same ray. Kensler and Shirley 2006, "Optimizing
// Ray-Triangle Intersection via Automated Search", section 2.
[[nodiscard]] inline bool testTriangle(
    const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2, const Ray& ray, TriangleHit& hit)
{
    const glm::dvec3 origin(ray.origin), direction(ray.direction);
    const glm::dvec3 a = glm::dvec3(v0) - origin, b = glm::dvec3(v1) - origin, c = glm::dvec3(v2) - origin;
    const double alpha = glm::dot(direction, glm::cross(c, b));
    const double beta = glm::dot(direction, glm::cross(a, c));
    const double gamma = glm::dot(direction, glm::cross(b, a));
    const bool anyNegative = (alpha < 0.0) | (beta < 0.0) | (gamma < 0.0);
    const bool anyPositive = (alpha > 0.0) | (beta > 0.0) | (gamma > 0.0);
    if (anyNegative == anyPositive) // outside, or edge-on
        return false;

    // The distance from the plane's equation: a weighted sum of the corners loses digits on huge triangles.
    const glm::vec3 normal = glm::cross(v1 - v0, v2 - v0);
    const float t = glm::dot(normal, v0 - ray.origin) / glm::dot(normal, ray.direction);
    if (!(t >= 0.0f && t <= ray.t)) // NaN fails too
        return false;
    hit = { t, { alpha, beta, gamma }, normal };
    return true;
}

}
