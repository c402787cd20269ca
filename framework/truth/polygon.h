#pragma once
#include <glm/vec2.hpp>
#include <vector>

namespace truth {

using Polygon = std::vector<glm::dvec2>; // convex, corners in either order; with fewer than three nothing

// What of the polygon has height(corner) >= 0, where height is linear. Sutherland and Hodgman 1974, "Reentrant Polygon
// Clipping".
template <typename Height> [[nodiscard]] Polygon clip(const Polygon& polygon, const Height& height)
{
    Polygon inside;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        const double a = height(from), b = height(to);
        if (a >= 0.0)
            inside.push_back(from);
        if ((a < 0.0) != (b < 0.0))
            inside.push_back(from + a / (a - b) * (to - from));
    }
    return inside;
}

[[nodiscard]] Polygon clipToRectangle(Polygon polygon, const glm::dvec2& lower, const glm::dvec2& upper);

[[nodiscard]] double areaOf(const Polygon& polygon);

}
