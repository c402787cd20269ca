#pragma once
#include <filesystem>
#include <map>

namespace submission {

// Notices when a source of a folder changes. A look at a dozen files a few times a second costs nothing, and works on
// every system and file system.
class WatchedFolder {
public:
    explicit WatchedFolder(std::filesystem::path folder);

    // Since the last call, or since the beginning.
    [[nodiscard]] bool hasChanged();

private:
    using Times = std::map<std::filesystem::path, std::filesystem::file_time_type>;
    [[nodiscard]] Times timesNow() const;

    std::filesystem::path m_folder;
    Times m_times;
};

}
