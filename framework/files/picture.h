#pragma once
#include <filesystem>
#include <framework/image.h>
#include <memory>

namespace files {

// Reads a PNG, JPEG, BMP or TGA file. The bottom row of the picture comes first, so that v = 0 addresses it.
// Throws Error.
[[nodiscard]] std::shared_ptr<const Image> loadPicture(const std::filesystem::path& path);

// The same picture, of which only the header is read: the rest when somebody first looks at a texel. Then the Error of
// a picture that is broken further on is thrown.
[[nodiscard]] std::shared_ptr<const Image> openPicture(const std::filesystem::path& path);

}
