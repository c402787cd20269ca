#pragma once
#include "grading/probes/interpolation.h"
#include <algorithm>
#include <array>
#include <glm/glm.hpp>

namespace grading {

using Corners = std::array<glm::dvec3, 3>;

[[nodiscard]] inline Corners cornersOf(const Triangle& triangle)
{
    return { glm::dvec3(triangle.v0), glm::dvec3(triangle.v1), glm::dvec3(triangle.v2) };
}

[[nodiscard]] inline double longestEdge(const Triangle& triangle)
{
    const auto [a, b, c] = cornersOf(triangle);
    return std::max({ glm::distance(a, b), glm::distance(b, c), glm::distance(c, a) });
}

// How many times longer than high: 1.15 if all edges are equal.
[[nodiscard]] inline double slenderness(const Triangle& triangle)
{
    const auto [a, b, c] = cornersOf(triangle);
    const double longest = longestEdge(triangle);
    return longest * longest / glm::length(glm::cross(b - a, c - a));
}

// How many times a rounding counts in coordinates: more in a slender triangle, and for a point that is far away.
[[nodiscard]] inline double conditionOf(const TrianglePoint& input)
{
    const double distance = glm::distance(glm::dvec3(input.triangle.v0), glm::dvec3(input.p));
    return slenderness(input.triangle) * std::max(1.0, distance / longestEdge(input.triangle));
}

[[nodiscard]] inline glm::dvec3 pointAt(const Corners& corners, const glm::dvec3& barycentric)
{
    return barycentric.x * corners[0] + barycentric.y * corners[1] + barycentric.z * corners[2];
}

// The barycentric coordinates of the triangle's point closest to p, by trying all: the three edges with their ends, and
// the foot of the perpendicular if it lies inside. Of a triangle without area, those of one of the closest.
[[nodiscard]] inline glm::dvec3 closestPoint(const Corners& corners, const glm::dvec3& p)
{
    glm::dvec3 closest { 1.0, 0.0, 0.0 };
    const auto consider = [&](const glm::dvec3& barycentric) {
        if (glm::distance(pointAt(corners, barycentric), p) < glm::distance(pointAt(corners, closest), p))
            closest = barycentric;
    };
    const std::array<glm::dvec3, 3> units { { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
    for (std::size_t from = 0; from < 3; ++from) {
        const std::size_t to = (from + 1) % 3;
        const glm::dvec3 edge = corners[to] - corners[from];
        const double squared = glm::dot(edge, edge);
        const double along = glm::dot(p - corners[from], edge);
        const double s = squared > 0.0 ? std::clamp(along / squared, 0.0, 1.0) : 0.0;
        consider(glm::mix(units[from], units[to], s));
    }
    // The foot corners[0] + beta * e + gamma * f, by Cramer's rule.
    const glm::dvec3 e = corners[1] - corners[0];
    const glm::dvec3 f = corners[2] - corners[0];
    const glm::dvec3 d = p - corners[0];
    const double ee = glm::dot(e, e), ef = glm::dot(e, f), ff = glm::dot(f, f);
    const double determinant = ee * ff - ef * ef;
    const double beta = (ff * glm::dot(d, e) - ef * glm::dot(d, f)) / determinant;
    const double gamma = (ee * glm::dot(d, f) - ef * glm::dot(d, e)) / determinant;
    if (determinant > 0.0 && beta >= 0.0 && gamma >= 0.0 && beta + gamma <= 1.0)
        consider({ 1.0 - beta - gamma, beta, gamma });
    return closest;
}

}
