#include "submission/cache.h"
#include "submission/paths.h"
#include <algorithm>
#include <atomic>
#include <fmt/format.h>
#include <stdexcept>
#include <unistd.h>
#include <vector>

namespace submission {
namespace {

    namespace fs = std::filesystem;

    // Of about half a megabyte each: some two hundred submissions whose files all differ.
    constexpr std::size_t maxFolders = 3000;

    fs::path freshFolder()
    {
        static std::atomic<int> count { 0 };
        const fs::path folder = cacheFolder() / fmt::format("new-{}-{}", getpid(), count++);
        fs::remove_all(folder);
        fs::create_directories(folder);
        return folder;
    }

    fs::file_time_type lastUse(const fs::path& folder)
    {
        std::error_code gone; // another grader may remove it at the same time
        return fs::last_write_time(folder, gone);
    }

    void noteUse(const fs::path& folder)
    {
        std::error_code gone;
        fs::last_write_time(folder, fs::file_time_type::clock::now(), gone);
    }

    // The half that was not used for longest. Those in use are among the most recent.
    void prune()
    {
        std::vector<fs::path> folders;
        for (const fs::directory_entry& entry : fs::directory_iterator(cacheFolder()))
            folders.push_back(entry.path());
        if (folders.size() <= maxFolders)
            return;
        const auto middle = folders.begin() + maxFolders / 2;
        std::nth_element(folders.begin(), middle, folders.end(),
            [](const fs::path& a, const fs::path& b) { return lastUse(a) > lastUse(b); });
        std::error_code gone;
        std::for_each(middle, folders.end(), [&](const fs::path& folder) { fs::remove_all(folder, gone); });
    }

    // A compiler without room to write says all kinds of things.
    void expectRoom()
    {
        constexpr std::uintmax_t enough = std::uintmax_t(16) << 20;
        if (fs::space(cacheFolder()).available < enough)
            throw std::runtime_error(fmt::format("the disk of {} is full", cacheFolder().string()));
    }

}

fs::path cacheFolder()
{
    return fs::path(buildDirectory) / "submissions";
}

fs::path cached(const std::string& key, const std::function<bool(const fs::path&)>& make)
{
    const fs::path folder = cacheFolder() / key;
    if (fs::exists(folder)) {
        noteUse(folder);
        return folder;
    }
    const fs::path fresh = freshFolder();
    const bool isWorthKeeping = make(fresh);
    expectRoom();
    if (!isWorthKeeping)
        return fresh;
    std::error_code taken; // by another who made the same
    fs::rename(fresh, folder, taken);
    if (taken)
        fs::remove_all(fresh);
    prune();
    return folder;
}

}
