#pragma once
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace app {

// Writes a picture, row 0 of the pixels at the bottom: .png with colours clamped to [0, 1] and stored as they are, .exr
// with all that they hold. The file appears whole or not at all. Throws files::Error.
void savePicture(const std::filesystem::path& path, glm::ivec2 size, std::span<const glm::vec3> pixels);

// Throws files::Error for a name that savePicture would not take.
void checkPictureName(const std::filesystem::path& path);

}
