#pragma once
#include <filesystem>

namespace submission {

[[nodiscard]] inline bool isBelow(const std::filesystem::path& path, const std::filesystem::path& folder)
{
    const std::filesystem::path relative = path.lexically_relative(folder);
    return !relative.empty() && *relative.begin() != "..";
}

}
