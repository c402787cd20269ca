#pragma once
#include "files/obj_syntax.h"
#include <array>
#include <glm/vec3.hpp>
#include <span>

namespace files {

// Throws Error unless the triangles, indices of positions in the order of the file, cover all faces. tinyobj drops
// what remains of a polygon when it finds no more ears, and takes corners of concave ones for ears that are none.
void checkTriangulation(const std::filesystem::path& path, const ObjOutline& outline,
    std::span<const glm::vec3> positions, std::span<const std::array<uint32_t, 3>> triangles);

}
