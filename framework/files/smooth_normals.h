#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace files {

// A unit normal for each position: the mean of those of the triangles around it, weighted by their areas.
[[nodiscard]] std::vector<glm::vec3> computeSmoothNormals(
    std::span<const glm::vec3> positions, std::span<const std::array<uint32_t, 3>> triangles);

}
