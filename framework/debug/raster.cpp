#include "debug/raster.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace debug {
namespace {

    float distanceToSegment(const glm::vec2& p, const glm::vec2& a, const glm::vec2& b)
    {
        const glm::vec2 ab = b - a;
        const float lengthSquared = glm::dot(ab, ab);
        const float s = lengthSquared > 0.0f ? glm::clamp(glm::dot(p - a, ab) / lengthSquared, 0.0f, 1.0f) : 0.0f;
        return glm::distance(p, a + s * ab);
    }

    // How far outside a convex polygon a point lies, negative within; where it is outside two edges, a little less.
    float distanceToArea(const glm::vec2& p, const std::vector<glm::vec2>& corners)
    {
        float area = 0.0f, left = -INFINITY, right = -INFINITY; // for either sense of rotation
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const glm::vec2 a = corners[i], edge = corners[(i + 1) % corners.size()] - a;
            const float length = glm::length(edge);
            area += a.x * (a.y + edge.y) - (a.x + edge.x) * a.y;
            if (length == 0.0f)
                continue;
            const float outside = (edge.y * (p.x - a.x) - edge.x * (p.y - a.y)) / length;
            left = std::max(left, outside);
            right = std::max(right, -outside);
        }
        return area > 0.0f ? left : right;
    }

    // 1 within, 0 outside, and the pixel's share where the border runs through it.
    float coverage(const Stroke& stroke, const glm::vec2& p)
    {
        constexpr float halfWidth = 1.0f;
        const float distance = stroke.isFilled ? distanceToArea(p, stroke.points)
                                               : distanceToSegment(p, stroke.points[0], stroke.points[1]) - halfWidth;
        return glm::clamp(0.5f - distance, 0.0f, 1.0f);
    }

    struct Bounds {
        glm::ivec2 first, last;
    };

    Bounds boundsOf(const Stroke& stroke, glm::ivec2 size)
    {
        glm::vec2 lower = stroke.points[0], upper = lower;
        for (const glm::vec2& point : stroke.points) {
            lower = glm::min(lower, point);
            upper = glm::max(upper, point);
        }
        constexpr float margin = 2.0f;
        const glm::vec2 last = glm::vec2(size) - 1.0f;
        return { glm::ivec2(glm::clamp(lower - margin, glm::vec2(0.0f), last)),
            glm::ivec2(glm::clamp(upper + margin, glm::vec2(0.0f), last)) };
    }

}

void drawOver(std::span<glm::vec3> pixels, glm::ivec2 size, const std::vector<Stroke>& strokes)
{
    for (const Stroke& stroke : strokes) {
        const auto [first, last] = boundsOf(stroke, size);
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x) {
                glm::vec3& pixel = pixels[static_cast<std::size_t>(y * size.x + x)];
                const float share = coverage(stroke, glm::vec2(x, y) + 0.5f) * stroke.opacity;
                pixel = glm::mix(pixel, stroke.color, share);
            }
    }
}

}
