#include "report/location.h"
#include "files/text.h"
#include <algorithm>
#include <regex>
#include <vector>

namespace report {
namespace {

    namespace fs = std::filesystem;

    std::vector<fs::path> sourcesOf(const fs::path& folder, const std::string& first)
    {
        std::vector<fs::path> paths;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
            if (entry.path().extension() == ".cpp")
                paths.push_back(entry.path());
        std::ranges::sort(paths);
        std::ranges::stable_partition(paths, [&](const fs::path& path) { return path == folder / first; });
        return paths;
    }

    // A definition starts at the beginning of a line with its type; what it ends with may stand lines below, so that a
    // body comes before a semicolon does.
    int lineOfDefinition(const std::string& text, const std::string& function)
    {
        const std::regex definition("(^|\\n)(?!return|//)[A-Za-z_][^\\n;(){}=]*[ &*]" + function + "\\s*\\([^;{]*\\{");
        std::smatch match;
        if (!std::regex_search(text, match, definition))
            return 0;
        const auto start = match[0].first + (*match[0].first == '\n');
        return 1 + static_cast<int>(std::count(text.begin(), start, '\n'));
    }

}

Location locate(const std::string& function, const fs::path& folder, const std::string& file)
{
    for (const fs::path& path : sourcesOf(folder, file))
        if (const int line = lineOfDefinition(files::readText(path), function); line > 0)
            return { function, path.lexically_relative(folder).string(), line };
    return { function, "", 0 };
}

}
