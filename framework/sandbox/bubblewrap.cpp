#include "sandbox/bubblewrap.h"
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>

namespace sandbox {
namespace {

    namespace fs = std::filesystem;
    using Words = std::vector<std::string>;

    fs::path findBubblewrap()
    {
        const char* const path = std::getenv("PATH");
        std::istringstream folders(path ? path : "/usr/bin:/bin");
        for (std::string folder; std::getline(folders, folder, ':');)
            if (fs::path program = fs::path(folder) / "bwrap"; program.is_absolute() && fs::exists(program))
                return program;
        return {};
    }

    const fs::path& bubblewrap()
    {
        static const fs::path program = findBubblewrap();
        return program;
    }

    void append(Words& words, std::initializer_list<std::string> more)
    {
        words.insert(words.end(), more);
    }

    // Programs and libraries. /bin, /lib and the like are links into /usr on most systems, and folders on some.
    void appendSystem(Words& words)
    {
        append(words, { "--ro-bind", "/usr", "/usr" });
        for (const fs::path folder : { "/bin", "/sbin", "/lib", "/lib32", "/lib64" }) {
            if (fs::is_symlink(folder))
                append(words, { "--symlink", fs::read_symlink(folder).string(), folder.string() });
            else
                append(words, { "--ro-bind-try", folder.string(), folder.string() });
        }
        for (const std::string path : { "/etc/alternatives", "/etc/ld.so.cache" })
            append(words, { "--ro-bind-try", path, path });
    }

    bool showsEverything(const View& view)
    {
        return std::find(view.readable.begin(), view.readable.end(), "/") != view.readable.end();
    }

    void appendView(Words& words, const View& view)
    {
        if (showsEverything(view))
            append(words, { "--ro-bind", "/", "/" });
        else
            appendSystem(words);
        append(words, { "--proc", "/proc", "--dev", "/dev" });
        if (view.hasTemporary) {
            const std::string most = std::to_string(std::size_t(256) << 20); // bytes: it is kept in memory
            append(words, { "--size", most, "--tmpfs", "/tmp" });
        }
        if (!showsEverything(view))
            for (const fs::path& path : view.readable)
                append(words, { "--ro-bind", path.string(), path.string() });
        if (!view.writable.empty())
            append(words, { "--bind", view.writable.string(), view.writable.string() });
        // What lies around the mounts is kept in memory too, and would not be limited.
        append(words, { "--remount-ro", "/", "--remount-ro", "/dev" });
    }

    bool isTurnedOff = false;

    std::string tryIt()
    {
        if (isTurnedOff)
            return "turned off";
        if (bubblewrap().empty())
            return "bubblewrap is not installed";
        std::string command;
        for (const std::string& word : bubblewrapWords({}, -1, -1))
            command += "'" + word + "' ";
        const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen((command + "/bin/true 2>&1").c_str(), "r"), pclose);
        std::array<char, 200> line {};
        const bool complained = pipe && std::fgets(line.data(), line.size(), pipe.get());
        const std::string said = complained ? line.data() : "";
        return said.substr(0, said.find('\n'));
    }

}

void turnOffBubblewrap()
{
    isTurnedOff = true;
}

const std::string& whyNoBubblewrap()
{
    static const std::string reason = tryIt();
    return reason;
}

std::vector<std::string> bubblewrapWords(const View& view, int info, int filter)
{
    Words words { bubblewrap().string(), "--unshare-all", "--die-with-parent", "--new-session", "--cap-drop", "ALL" };
    if (info >= 0)
        append(words, { "--info-fd", std::to_string(info) });
    if (filter >= 0)
        append(words, { "--seccomp", std::to_string(filter) });
    appendView(words, view);
    return words;
}

}
