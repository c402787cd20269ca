#pragma once
#include <framework/trackball.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace debug {

// Where a camera's picture shows what lies in the scene. Pixels are counted from the bottom left.
class Projection {
public:
    Projection(const Trackball& camera, glm::ivec2 size);

    // Of what lies in front of the camera.
    [[nodiscard]] std::optional<glm::vec2> point(const glm::vec3& position) const;

    // What lies in front of the camera of a line between two points.
    [[nodiscard]] std::optional<std::pair<glm::vec2, glm::vec2>> line(const glm::vec3& a, const glm::vec3& b) const;

    // Outline of a ball, as a regular polygon that faces the camera; empty when that is not in front of it.
    [[nodiscard]] std::vector<glm::vec2> ball(const glm::vec3& center, float radius) const;

private:
    [[nodiscard]] glm::vec3 toCamera(const glm::vec3& position) const; // left, up, forward
    [[nodiscard]] glm::vec2 toPixel(const glm::vec3& inCamera) const;

    Trackball m_camera;
    glm::vec2 m_size;
    glm::vec2 m_extent; // of the picture at distance 1: half its width and height
};

}
