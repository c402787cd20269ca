#include "submission/includes.h"
#include "submission/is_below.h"
#include "submission/paths.h"
#include <algorithm>
#include <fstream>

namespace submission {

namespace fs = std::filesystem;

static const fs::path framework = fs::path(sourceDirectory) / "framework";

std::vector<fs::path> interfaceHeaders()
{
    std::vector<fs::path> headers { framework / "framework", framework / "imgui" };
    for (const fs::directory_entry& entry : fs::directory_iterator(framework))
        if (entry.path().extension() == ".h")
            headers.push_back(entry.path());
    return headers;
}

static bool isOfTheInterface(const fs::path& header)
{
    const fs::path folder = header.parent_path();
    return folder == framework || folder == framework / "framework" || folder == framework / "imgui";
}

std::string firstForeignInclude(const fs::path& folder, const std::string& dependencies)
{
    std::ifstream words(folder / dependencies);
    for (std::string word; words >> word;) {
        std::error_code failed;
        const fs::path path = fs::weakly_canonical(folder / word, failed);
        if (failed) // a path that no honest file needs
            return word.substr(0, 100);
        if (isBelow(path, sourceDirectory) && !isBelow(path, buildDirectory) && !isOfTheInterface(path))
            return path.lexically_relative(sourceDirectory).string();
    }
    return "";
}

}
