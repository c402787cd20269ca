#include "submission/cache.h"
#include "submission/paths.h"
#include "submission/prune.h"
#include <cerrno>
#include <cstdlib>
#include <fmt/format.h>
#include <mutex>
#include <stdexcept>
#include <system_error>

namespace submission {
namespace {

    namespace fs = std::filesystem;

    // Of about half a megabyte each: some two hundred submissions whose files all differ.
    constexpr std::size_t maxFolders = 3000;

    // A folder that nobody else has, gone with this unless it is kept.
    class FreshFolder {
    public:
        FreshFolder()
        {
            fs::create_directories(cacheFolder());
            std::string name = cacheFolder() / "new-XXXXXX";
            if (!mkdtemp(name.data()))
                throw std::system_error(errno, std::generic_category(), name);
            m_path = name;
        }
        ~FreshFolder()
        {
            std::error_code gone;
            if (!m_isKept)
                fs::remove_all(m_path, gone);
        }
        FreshFolder(const FreshFolder&) = delete;
        FreshFolder& operator=(const FreshFolder&) = delete;

        [[nodiscard]] const fs::path& path() const { return m_path; }
        void keep() { m_isKept = true; }

        // Another may have made the same in the meantime: then that is as good.
        void keepAs(const fs::path& folder)
        {
            std::error_code taken;
            fs::rename(m_path, folder, taken);
            m_isKept = !taken;
        }

    private:
        fs::path m_path;
        bool m_isKept = false;
    };

    // A compiler without room to write says all kinds of things.
    void expectRoom()
    {
        constexpr std::uintmax_t enough = std::uintmax_t(16) << 20;
        if (fs::space(cacheFolder()).available < enough)
            throw std::runtime_error(fmt::format("the disk of {} is full", cacheFolder().string()));
    }

}

fs::path keptFolder()
{
    const char* const own = std::getenv("RAYWORK_CACHE");
    return own && *own ? fs::absolute(own) : fs::path(buildDirectory);
}

fs::path cacheFolder()
{
    return keptFolder() / "submissions";
}

fs::path cached(const std::string& key, const std::function<bool(const fs::path&)>& make)
{
    const fs::path folder = cacheFolder() / key;
    if (fs::exists(folder)) {
        noteUse(folder);
        return folder;
    }
    FreshFolder fresh;
    const bool isWorthKeeping = make(fresh.path());
    expectRoom();
    if (!isWorthKeeping) {
        fresh.keep(); // until it is pruned: whoever asked for it looks at it still
        return fresh.path();
    }
    fresh.keepAs(folder);
    static std::once_flag pruned;
    std::call_once(pruned, [] { prune(cacheFolder(), maxFolders); });
    return folder;
}

}
