#pragma once
#include "accel/wide/node.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <framework/ray.h>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

// What a ray may meet, by Cramer's rule in double precision over all triangles. Where a float cannot tell, near edges
// and near the ends of the ray, it says so.
class ExactHits {
public:
    using Triangle = std::array<glm::vec3, 3>;

    ExactHits(const std::vector<Triangle>& triangles, const Ray& ray)
        : m_triangles(triangles)
        , m_ray(ray)
    {
        for (const Triangle& triangle : triangles)
            if (const Meeting m = meet(triangle);
                m.inside > margin / m.grip && m.t > margin / m.grip && m.t < static_cast<double>(ray.t))
                m_closest = std::min(m_closest, m.t);
    }

    [[nodiscard]] bool isSurelyHit() const { return m_closest < std::numeric_limits<double>::infinity(); }

    // Whether the triangle is met there, and none surely before it.
    [[nodiscard]] bool mayBe(const accel::wide::Hit& hit) const
    {
        const Meeting m = meet(m_triangles[hit.primitive]);
        const double t = static_cast<double>(hit.t), u = static_cast<double>(hit.u), v = static_cast<double>(hit.v);
        const bool isThere = m.inside > -margin / m.grip && std::abs(m.t - t) < margin / m.grip;
        const bool hasWeights = std::abs(m.u - u) < margin / m.grip && std::abs(m.v - v) < margin / m.grip;
        return isThere && hasWeights && t <= m_closest + margin / m.grip;
    }

private:
    struct Meeting {
        double t, u, v;
        double inside; // the least of the three weights
        double grip; // small for triangles that are small, thin or seen edge-on: what divides roundings
    };

    static constexpr double margin = 1e-5; // a hundred roundings of coordinates near 1

    [[nodiscard]] Meeting meet(const Triangle& triangle) const
    {
        const glm::dvec3 a { triangle[0] }, b { triangle[1] }, c { triangle[2] };
        const glm::dvec3 origin { m_ray.origin }, direction { m_ray.direction };
        const glm::dvec3 normal = glm::cross(b - a, c - a), toOrigin = origin - a;
        const double slope = -glm::dot(normal, direction);
        const double u = glm::dot(glm::cross(direction, c - a), toOrigin) / slope;
        const double v = -glm::dot(glm::cross(direction, b - a), toOrigin) / slope;
        const double t = glm::dot(normal, toOrigin) / slope;
        const double longest = std::max({ glm::dot(b - a, b - a), glm::dot(c - a, c - a), glm::dot(c - b, c - b) });
        const double fatness = std::abs(slope) / (longest * glm::length(direction));
        return { t, u, v, std::min({ u, v, 1.0 - u - v }), fatness * std::min(1.0, std::sqrt(longest)) };
    }

    const std::vector<Triangle>& m_triangles;
    Ray m_ray;
    double m_closest = std::numeric_limits<double>::infinity();
};
