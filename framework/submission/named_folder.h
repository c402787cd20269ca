#pragma once
#include <filesystem>
#include <string>

namespace submission {

// Whose code: "student" and "reference" are folders of this project, anything else is a path.
[[nodiscard]] std::filesystem::path namedFolder(const std::string& name);

}
