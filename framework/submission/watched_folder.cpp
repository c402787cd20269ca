#include "submission/watched_folder.h"

namespace submission {

namespace fs = std::filesystem;

WatchedFolder::WatchedFolder(fs::path folder)
    : m_folder(std::move(folder))
    , m_times(timesNow())
{
}

bool WatchedFolder::hasChanged()
{
    Times now = timesNow();
    const bool isChanged = now != m_times;
    m_times = std::move(now);
    return isChanged;
}

// Of the sources alone: what is written about them may lie there too. Editors write in steps: a file may be gone for a
// moment.
WatchedFolder::Times WatchedFolder::timesNow() const
{
    Times times;
    std::error_code gone;
    for (auto file = fs::recursive_directory_iterator(m_folder, gone); file != fs::recursive_directory_iterator();
         file.increment(gone))
        if (file->path().extension() == ".cpp")
            times[file->path()] = fs::last_write_time(file->path(), gone);
    return times;
}

}
