#pragma once
#include <filesystem>
#include <string_view>

namespace grading {

// Writes the file: whole, or not at all, so that whoever reads it beside us sees the old text or the new one. It is on
// the disk when this returns. Throws files::Error if nothing can be created there, and std::system_error if writing
// fails later, as on a full disk.
void writeWhole(const std::filesystem::path& path, std::string_view text);

}
