#include "submission/includes.h"
#include "submission/paths.h"
#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>

namespace submission {

namespace fs = std::filesystem;

static bool isOfTheInterface(const fs::path& header)
{
    const fs::path framework = fs::path(sourceDirectory) / "framework";
    const std::array folders { framework, framework / "framework", framework / "imgui" };
    return std::find(folders.begin(), folders.end(), header.parent_path()) != folders.end();
}

std::string firstForeignInclude(const std::string& dependencies)
{
    std::istringstream words(dependencies);
    for (std::string word; words >> word;) {
        const fs::path path = fs::weakly_canonical(fs::path(buildDirectory) / "submissions" / "any" / word);
        const fs::path fromRoot = path.lexically_relative(sourceDirectory);
        const bool isOurs = !fromRoot.empty() && *fromRoot.begin() != "..";
        const bool isBuilt = path.lexically_relative(buildDirectory).begin()->string() != "..";
        if (isOurs && !isBuilt && !isOfTheInterface(path))
            return fromRoot.string();
    }
    return "";
}

}
