#pragma once
#include "scene.h"
#include <array>
#include <span>

namespace values {

// One mesh of these triangles, without normals and texture coordinates.
[[nodiscard]] Scene sceneOf(std::span<const std::array<glm::vec3, 3>> triangles);

}
