#include "bench/exact_hits.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace bench {
namespace {

    // Sixteen of the largest relative error of one, 2^-24: Woop, Benthin and Wald 2013, section 4, count five along
    // each of two axes.
    constexpr double roundings = 0x1p-20;

    // Of the largest number that has to do with the ray.
    double toleranceFor(std::span<const Triangle> triangles, const glm::dvec3& origin)
    {
        glm::dvec3 reach(0.0);
        for (const Triangle& triangle : triangles)
            for (const glm::vec3& corner : triangle)
                reach = glm::max(reach, glm::abs(glm::dvec3(corner) - origin));
        return roundings * (glm::length(reach) + glm::length(origin));
    }

    // How the line of a ray passes a triangle. Not a number where the triangle has no area.
    struct Passing {
        Passing(const Triangle& triangle, const Ray& ray)
        {
            const glm::dvec3 origin(ray.origin), direction(ray.direction);
            const std::array corners { glm::dvec3(triangle[0]) - origin, glm::dvec3(triangle[1]) - origin,
                glm::dvec3(triangle[2]) - origin };
            const auto& [a, b, c] = corners;
            const std::array volumes { glm::dot(direction, glm::cross(c, b)), glm::dot(direction, glm::cross(a, c)),
                glm::dot(direction, glm::cross(b, a)) };
            const double side = std::copysign(1.0, volumes[0] + volumes[1] + volumes[2]);
            double longest = 0.0;
            for (std::size_t i = 0; i < 3; ++i) {
                const glm::dvec3 edge = corners[(i + 2) % 3] - corners[(i + 1) % 3];
                longest = std::max(longest, glm::dot(edge, edge));
                inside = std::min(side * volumes[i] / glm::length(glm::cross(direction, edge)), inside);
            }
            const glm::dvec3 normal = glm::cross(b - a, c - a);
            const double slope = glm::dot(normal, direction);
            distance = glm::dot(normal, a) / slope;
            stretch = glm::length(normal) / std::abs(slope);
            aspect = longest * glm::length(direction) / std::abs(slope);
        }

        double inside = std::numeric_limits<double>::infinity(); // how far from the nearest edge; negative: outside
        double distance; // in units of the ray's direction
        double stretch; // how far that moves when the triangle does
        double aspect; // the square of the longest edge over the area as seen along the ray, twice
    };

}

ExactHits::ExactHits(std::span<const Triangle> triangles, const Ray& ray)
    : m_triangles(triangles)
    , m_ray(ray)
    , m_tolerance(toleranceFor(triangles, glm::dvec3(ray.origin)))
{
    for (const Triangle& triangle : triangles)
        add(triangle);
}

void ExactHits::add(const Triangle& triangle)
{
    const Passing passing(triangle, m_ray);
    if (!(passing.inside >= -m_tolerance))
        return;
    const double end = static_cast<double>(m_ray.t), distance = passing.distance;
    const double least = distance - m_tolerance * passing.stretch, most = distance + m_tolerance * passing.stretch;
    m_mayHit |= most >= 0.0 && least <= end * (1.0 + roundings);
    if (passing.inside > m_tolerance && least > 0.0 && most < end)
        m_closestSure = std::min(m_closestSure, most);
    if (passing.inside >= 0.0 && distance >= 0.0 && distance <= end && distance < m_closest) {
        m_closest = distance;
        m_triangle = &triangle;
    }
}

Verdict ExactHits::judge(const std::optional<accel::wide::Hit>& found) const
{
    if (!found)
        return judge(false);
    if (!isAt(*found) || static_cast<double>(found->t) > m_closestSure * (1.0 + roundings))
        return Verdict::Wrong;
    return &m_triangles[found->primitive] == m_triangle ? Verdict::Exact : Verdict::Tie;
}

Verdict ExactHits::judge(bool found) const
{
    if (found == (m_triangle != nullptr))
        return Verdict::Exact;
    const bool isPossible = found ? m_mayHit : m_closestSure == infinity;
    return isPossible ? Verdict::Tie : Verdict::Wrong;
}

// Whether the triangle is met, there, and by these weights.
bool ExactHits::isAt(const accel::wide::Hit& hit) const
{
    const Triangle& triangle = m_triangles[hit.primitive];
    const Passing passing(triangle, m_ray);
    const double t = static_cast<double>(hit.t), u = static_cast<double>(hit.u), v = static_cast<double>(hit.v);
    const bool isThere = passing.inside >= -m_tolerance
        && std::abs(t - passing.distance) <= m_tolerance * passing.stretch + roundings * std::abs(t);
    const glm::dvec3 a(triangle[0]), b(triangle[1]), c(triangle[2]), direction(m_ray.direction);
    const glm::dvec3 weighted = a + u * (b - a) + v * (c - a) - glm::dvec3(m_ray.origin);
    const double aside = glm::length(glm::cross(weighted, direction)) / glm::length(direction);
    return isThere && aside <= m_tolerance * std::max(1.0, passing.aspect); // weights are shares of the area
}

}
