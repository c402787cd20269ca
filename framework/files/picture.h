#pragma once
#include <filesystem>
#include <framework/image.h>
#include <memory>

namespace files {

// Reads a PNG, JPEG, BMP or TGA file. The bottom row of the picture comes first, so that v = 0 addresses it.
// Throws Error.
[[nodiscard]] std::shared_ptr<const Image> loadPicture(const std::filesystem::path& path);

}
