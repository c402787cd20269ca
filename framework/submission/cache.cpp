#include "submission/cache.h"
#include "submission/paths.h"
#include "submission/prune.h"
#include <atomic>
#include <fmt/format.h>
#include <mutex>
#include <stdexcept>
#include <unistd.h>

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
    static std::once_flag pruned;
    std::call_once(pruned, [] { prune(cacheFolder(), maxFolders); });
    return folder;
}

}
