#pragma once
#include "config.h"
#include <filesystem>

namespace files {

// Writes a file with the [camera] of a scene file alone, from which loadCamera reads the same to the last bit. It
// appears whole or not at all. Throws Error: it cannot be written, or a value is one that no scene file may have.
void saveCamera(const std::filesystem::path& to, const CameraConfig& camera);

// The [camera] of a scene file, or of a file with nothing else. Throws Error, also where there is none.
[[nodiscard]] CameraConfig loadCamera(const std::filesystem::path& path);

// Whether a file has a [camera] and nothing else. Throws Error.
[[nodiscard]] bool isCameraFile(const std::filesystem::path& path);

}
