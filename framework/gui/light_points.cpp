#include "gui/light_points.h"
#include <framework/variant_helper.h>

namespace gui {

std::vector<glm::vec3> pointsOf(const Scene::SceneLight& light)
{
    using Points = std::vector<glm::vec3>;
    return std::visit(make_visitor([](const PointLight& l) { return Points { l.position }; },
                          [](const SegmentLight& l) {
                              return Points { l.endpoint0, l.endpoint1 };
                          },
                          [](const ParallelogramLight& l) {
                              return Points { l.v0, l.v0 + l.edge01, l.v0 + l.edge02 };
                          }),
        light);
}

std::vector<std::pair<glm::vec3, glm::vec3>> linesOf(const Scene::SceneLight& light)
{
    const auto p = pointsOf(light);
    if (p.size() == 1)
        return {};
    if (p.size() == 2)
        return { { p[0], p[1] } };
    const glm::vec3 opposite = p[1] + p[2] - p[0];
    return { { p[0], p[1] }, { p[1], opposite }, { opposite, p[2] }, { p[2], p[0] } };
}

void movePoint(Scene::SceneLight& light, std::size_t point, const glm::vec3& position)
{
    std::vector<glm::vec3> points = pointsOf(light);
    points.at(point) = position;
    std::visit(make_visitor([&](PointLight& l) { l.position = position; },
                   [&](SegmentLight& l) { (point == 0 ? l.endpoint0 : l.endpoint1) = position; },
                   [&](ParallelogramLight& l) {
                       // An edge between points that stay keeps its last bit.
                       l.v0 = points[0];
                       if (point != 2)
                           l.edge01 = points[1] - points[0];
                       if (point != 1)
                           l.edge02 = points[2] - points[0];
                   }),
        light);
}

std::optional<LightPoint> pointAt(const std::vector<Scene::SceneLight>& lights, const debug::Projection& projection,
    const glm::vec2& place, float radius)
{
    std::optional<LightPoint> found;
    for (std::size_t light = 0; light < lights.size(); ++light) {
        const auto points = pointsOf(lights[light]);
        for (std::size_t point = 0; point < points.size(); ++point) {
            const auto shown = projection.point(points[point]);
            if (shown && glm::distance(*shown, place) < radius) {
                radius = glm::distance(*shown, place);
                found = { light, point };
            }
        }
    }
    return found;
}

glm::vec3 positionAt(const glm::vec2& place, const Trackball& camera, glm::ivec2 size, const glm::vec3& asFarAs)
{
    const Ray ray = camera.generateRay(place / glm::vec2(size) * 2.0f - 1.0f);
    const float depth = glm::dot(asFarAs - ray.origin, camera.forward());
    return ray.origin + depth / glm::dot(ray.direction, camera.forward()) * ray.direction;
}

}
