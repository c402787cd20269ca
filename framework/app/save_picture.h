#pragma once
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace app {

// The picture could not be written; why stands on the terminal already.
struct PictureNotSaved { };

// Throws files::Error for a name that savePicture would not take.
void checkPictureName(const std::filesystem::path& path);

// Writes a picture, row 0 of the pixels at the bottom: .png with colours clamped to [0, 1], .exr with values as they
// are. The file appears whole or not at all. A process of its own writes it: the library for it takes longer to load
// than the rest of a render to start. Throws PictureNotSaved.
void savePicture(const std::filesystem::path& path, glm::ivec2 size, std::span<const glm::vec3> pixels);

}
