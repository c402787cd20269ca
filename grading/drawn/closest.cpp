#include "grading/drawn/closest.h"
#include "grading/drawn/near.h"
#include <framework/variant_helper.h>

namespace grading {

static float shareAlong(const glm::vec3& edge, const glm::vec3& offset)
{
    return std::clamp(glm::dot(offset, edge) / glm::dot(edge, edge), 0.0f, 1.0f);
}

glm::vec3 closestOnLight(const Scene::SceneLight& light, const glm::vec3& point)
{
    const auto closest = make_visitor([](const PointLight& l) { return l.position; },
        [&](const SegmentLight& l) {
            const glm::vec3 edge = l.endpoint1 - l.endpoint0;
            return l.endpoint0 + shareAlong(edge, point - l.endpoint0) * edge;
        },
        [&](const ParallelogramLight& l) {
            return l.v0 + shareAlong(l.edge01, point - l.v0) * l.edge01 + shareAlong(l.edge02, point - l.v0) * l.edge02;
        });
    return std::visit(closest, light);
}

// From the one to the other and back, until both are the same point or stay apart: alternating projections, Cheney and
// Goldstein 1959.
bool pointsAt(const Ray& ray, const Scene::SceneLight& light)
{
    const glm::vec3 direction = glm::normalize(ray.direction);
    glm::vec3 onRay = ray.origin;
    glm::vec3 onLight = closestOnLight(light, onRay);
    for (int i = 0; i < 20; ++i) {
        onRay = ray.origin + std::max(0.0f, glm::dot(onLight - ray.origin, direction)) * direction;
        onLight = closestOnLight(light, onRay);
    }
    return isNear(onRay, onLight);
}

}
