#pragma once
#include "debug/projection.h"
#include "scene.h"

namespace gui {

// The points that say where a light is: the point itself, the ends of a segment, or v0 and its two neighbours.
[[nodiscard]] std::vector<glm::vec3> pointsOf(const Scene::SceneLight& light);

// The lines that a light is drawn as: none, the segment, or the four edges.
[[nodiscard]] std::vector<std::pair<glm::vec3, glm::vec3>> linesOf(const Scene::SceneLight& light);

// Moves one point of pointsOf; the light's others stay where they are.
void movePoint(Scene::SceneLight& light, std::size_t point, const glm::vec3& position);

// One point of one light among several.
struct LightPoint {
    std::size_t light = 0, point = 0;

    [[nodiscard]] bool operator==(const LightPoint&) const = default;
};

// The point that is shown nearest to a place of the picture, if any is shown closer to it than the radius. In pixels,
// from the bottom left.
[[nodiscard]] std::optional<LightPoint> pointAt(const std::vector<Scene::SceneLight>& lights,
    const debug::Projection& projection, const glm::vec2& place, float radius);

// What is shown at that place of a picture of that size, as far ahead of the camera as a point that lies ahead of it.
[[nodiscard]] glm::vec3 positionAt(
    const glm::vec2& place, const Trackball& camera, glm::ivec2 size, const glm::vec3& asFarAs);

}
