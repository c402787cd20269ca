#include "truth/light.h"
#include "truth/integral.h"
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace truth {
namespace {

    constexpr double tolerance = 1e-11;

    using Corners = std::span<const glm::dvec3>;

    // What arrives from a point of the light.
    glm::dvec3 arriving(const Receiver& receiver, const glm::dvec3& position, const glm::dvec3& color)
    {
        const glm::dvec3 direction = glm::normalize(position - receiver.point);
        return color * receiver.kd * std::max(glm::dot(receiver.normal, direction), 0.0);
    }

    // How high above the surface.
    double heightOf(const Receiver& receiver, const glm::dvec3& position)
    {
        return glm::dot(receiver.normal, position - receiver.point);
    }

    // A parallelogram light's plane, with coordinates in [0, 1]^2 on the light.
    struct Sheet {
        glm::dvec3 corner, edge01, edge02;

        [[nodiscard]] glm::dvec3 at(const glm::dvec2& uv) const { return corner + uv.x * edge01 + uv.y * edge02; }

        // Where the line through both points meets it.
        [[nodiscard]] glm::dvec2 meet(const glm::dvec3& from, const glm::dvec3& through) const
        {
            const glm::dmat3 columns(edge01, edge02, from - through);
            return glm::dvec2(glm::inverse(columns) * (from - corner));
        }
    };

}

glm::dvec3 contribution(const ParallelogramLight& light, const Receiver& receiver, Corners blocker)
{
    const Sheet sheet { light.v0, light.edge01, light.edge02 };
    const auto fromLight = [&](const glm::dvec2& uv) {
        const glm::dvec3 near = glm::mix(glm::dvec3(light.color0), glm::dvec3(light.color1), uv.x);
        const glm::dvec3 far = glm::mix(glm::dvec3(light.color2), glm::dvec3(light.color3), uv.x);
        return arriving(receiver, sheet.at(uv), glm::mix(near, far, uv.y));
    };
    const auto height = [&](const glm::dvec2& uv) { return heightOf(receiver, sheet.at(uv)); };
    const glm::dvec2 lower(0.0), upper(1.0);
    Polygon shadow;
    for (const glm::dvec3& corner : blocker)
        shadow.push_back(sheet.meet(receiver.point, corner));
    const Polygon lit = clip(Polygon { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, height);
    const Polygon blocked = clip(clipToRectangle(std::move(shadow), lower, upper), height);
    return integrate(fromLight, lit, tolerance) - integrate(fromLight, blocked, tolerance);
}

// The segment as a sheet: what the blocker leaves of it is where the segment lies outside of the shadow in the plane
// through the point and the segment.
glm::dvec3 contribution(const SegmentLight& light, const Receiver& receiver, Corners blocker)
{
    const glm::dvec3 start(light.endpoint0), along = glm::dvec3(light.endpoint1) - start;
    const auto fromLight = [&](double s) {
        return arriving(receiver, start + s * along, glm::mix(glm::dvec3(light.color0), glm::dvec3(light.color1), s));
    };
    // In a sheet that the segment crosses the middle of, coordinates (s, 0).
    const glm::dvec3 aside = glm::normalize(glm::cross(along, start - receiver.point));
    const Sheet sheet { start, along, aside };
    Polygon shadow;
    for (const glm::dvec3& corner : blocker)
        shadow.push_back(sheet.meet(receiver.point, corner));
    double first = 1.0, last = 0.0; // where the shadow's outline crosses the segment
    for (std::size_t i = 0; i < shadow.size(); ++i) {
        const glm::dvec2 &a = shadow[i], &b = shadow[(i + 1) % shadow.size()];
        if ((a.y < 0.0) == (b.y < 0.0))
            continue;
        const double s = std::clamp(a.x + a.y / (a.y - b.y) * (b.x - a.x), 0.0, 1.0);
        first = std::min(first, s);
        last = std::max(last, s);
    }
    const double heights[] = { heightOf(receiver, start), heightOf(receiver, start + along) };
    double from = 0.0, to = 1.0; // above the surface
    if ((heights[0] < 0.0) != (heights[1] < 0.0))
        (heights[0] < 0.0 ? from : to) = heights[0] / (heights[0] - heights[1]);
    glm::dvec3 sum = integrate(fromLight, from, to, tolerance);
    if (first < last && std::max(first, from) < std::min(last, to))
        sum -= integrate(fromLight, std::max(first, from), std::min(last, to), tolerance);
    return sum;
}

}
