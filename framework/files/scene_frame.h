#pragma once
#include <glm/vec3.hpp>

namespace files {

// The coordinates of a scene file: its points and lengths become ours.
struct Frame {
    glm::vec3 origin { 0.0f };
    float unit = 1.0f;

    [[nodiscard]] glm::vec3 point(const glm::vec3& p) const { return (p - origin) * unit; }
    [[nodiscard]] glm::vec3 edge(const glm::vec3& e) const { return e * unit; }
    [[nodiscard]] float length(float l) const { return l * unit; }
};

}
