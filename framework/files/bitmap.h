#pragma once
#include <cstddef>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace files {

// Writes a BMP file; pixels have row 0 at the bottom and are clamped to [0, 1]. Throws Error.
void saveBitmap(const std::filesystem::path& path, glm::ivec2 resolution, std::span<const glm::vec3> pixels);

// The same picture as the bytes of a PNG file.
[[nodiscard]] std::vector<std::byte> encodePng(glm::ivec2 resolution, std::span<const glm::vec3> pixels);

}
