#pragma once
#include "files/digest.h"
#include "submission/paths.h"
#include <array>
#include <filesystem>

namespace grading {

// Where the scenes lie that checks render, and what these need.
[[nodiscard]] inline std::array<std::filesystem::path, 2> sceneFolders()
{
    const std::filesystem::path root { submission::sourceDirectory };
    return { root / "scenes", root / "grading" / "scenes" };
}

// Changes with any of them.
[[nodiscard]] inline const std::string& digestOfScenes()
{
    static const std::string digest = [] {
        files::Digest all;
        for (const std::filesystem::path& folder : sceneFolders())
            all.addFolder(folder);
        return all.hex();
    }();
    return digest;
}

}
