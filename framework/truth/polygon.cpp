#include "truth/polygon.h"
#include <cmath>

namespace truth {

Polygon clipToRectangle(Polygon polygon, const glm::dvec2& lower, const glm::dvec2& upper)
{
    polygon = clip(polygon, [&](const glm::dvec2& p) { return p.x - lower.x; });
    polygon = clip(polygon, [&](const glm::dvec2& p) { return upper.x - p.x; });
    polygon = clip(polygon, [&](const glm::dvec2& p) { return p.y - lower.y; });
    return clip(polygon, [&](const glm::dvec2& p) { return upper.y - p.y; });
}

// Relative to a corner, lest polygons far away lose digits.
double areaOf(const Polygon& polygon)
{
    double doubled = 0.0;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i - 1] - polygon[0], b = polygon[i] - polygon[0];
        doubled += a.x * b.y - a.y * b.x;
    }
    return 0.5 * std::abs(doubled);
}

}
