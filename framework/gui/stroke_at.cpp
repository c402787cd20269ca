#include "gui/stroke_at.h"
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace gui {
namespace {

    float distanceToLine(const glm::vec2& place, const glm::vec2& from, const glm::vec2& to)
    {
        const glm::vec2 along = to - from;
        const float squaredLength = glm::dot(along, along);
        const float t = squaredLength > 0.0f ? glm::dot(place - from, along) / squaredLength : 0.0f;
        return glm::distance(place, from + glm::clamp(t, 0.0f, 1.0f) * along);
    }

    float distanceToEdge(const debug::Stroke& stroke, const glm::vec2& place)
    {
        const auto& points = stroke.points;
        float least = stroke.isFilled ? distanceToLine(place, points.back(), points.front()) : INFINITY;
        for (std::size_t i = 1; i < points.size(); ++i)
            least = std::min(least, distanceToLine(place, points[i - 1], points[i]));
        return least;
    }

    // Of a convex area: it lies on the same side of all edges.
    bool covers(const debug::Stroke& stroke, const glm::vec2& place)
    {
        if (!stroke.isFilled)
            return false;
        bool isLeft = false, isRight = false;
        for (std::size_t i = 0; i < stroke.points.size(); ++i) {
            const glm::vec2 toPlace = place - stroke.points[i];
            const glm::vec2 along = stroke.points[(i + 1) % stroke.points.size()] - stroke.points[i];
            const float side = along.x * toPlace.y - along.y * toPlace.x;
            isLeft = isLeft || side > 0.0f;
            isRight = isRight || side < 0.0f;
        }
        return isLeft != isRight;
    }

}

std::optional<std::size_t> shapeAt(const std::vector<debug::Stroke>& strokes, const glm::vec2& place, float radius)
{
    std::optional<std::size_t> nearest, covering;
    for (const debug::Stroke& stroke : strokes) {
        if (const float distance = distanceToEdge(stroke, place); distance <= radius) {
            radius = distance;
            nearest = stroke.shape;
        }
        if (covers(stroke, place))
            covering = stroke.shape;
    }
    return nearest ? nearest : covering;
}

}
