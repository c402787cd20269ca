#include "submission/prune.h"
#include <algorithm>
#include <vector>

namespace submission {

namespace fs = std::filesystem;

void prune(const fs::path& folder, std::size_t maxEntries)
{
    struct Entry {
        fs::path path;
        fs::file_time_type lastUse;
    };
    std::error_code gone; // another process may remove it at the same time
    std::vector<Entry> entries;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        entries.push_back({ entry.path(), entry.last_write_time(gone) });
    if (entries.size() <= maxEntries)
        return;
    const auto middle = entries.begin() + static_cast<std::ptrdiff_t>(maxEntries / 2);
    std::nth_element(
        entries.begin(), middle, entries.end(), [](const Entry& a, const Entry& b) { return a.lastUse > b.lastUse; });
    std::for_each(middle, entries.end(), [&](const Entry& entry) { fs::remove_all(entry.path, gone); });
}

void pruneFiles(const fs::path& folder, std::uintmax_t mostBytes)
{
    struct File {
        fs::path path;
        fs::file_time_type lastUse;
        std::uintmax_t numBytes;
    };
    std::error_code gone; // as above
    std::vector<File> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, gone))
        if (entry.is_regular_file(gone))
            if (const std::uintmax_t numBytes = entry.file_size(gone); !gone)
                files.push_back({ entry.path(), entry.last_write_time(gone), numBytes });
    std::ranges::sort(files, std::ranges::greater(), &File::lastUse);
    std::uintmax_t sum = 0;
    for (const File& file : files)
        if ((sum += file.numBytes) > mostBytes)
            fs::remove(file.path, gone);
}

void noteUse(const fs::path& entry)
{
    std::error_code gone;
    fs::last_write_time(entry, fs::file_time_type::clock::now(), gone);
}

}
