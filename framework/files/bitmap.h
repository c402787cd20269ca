#pragma once
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace files {

// Writes a BMP file; pixels have row 0 at the bottom and are clamped to [0, 1]. Throws Error.
void saveBitmap(const std::filesystem::path& path, glm::ivec2 resolution, std::span<const glm::vec3> pixels);

}
