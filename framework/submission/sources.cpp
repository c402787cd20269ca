#include "submission/sources.h"
#include "files/error.h"
#include "files/text.h"
#include "submission/features.h"
#include "submission/handed_out.h"
#include <algorithm>
#include <cctype>
#include <vector>

namespace submission {
namespace {

    namespace fs = std::filesystem;

    constexpr std::uintmax_t maxBytes = 1 << 20; // the largest file of a real submission has a tenth of that

    constexpr std::size_t maxExtras = 32; // each may take a minute to compile

    // The files that the interface names, whether they are there or not. What cannot be looked at is not there.
    std::vector<std::string> partNames(const fs::path& submission)
    {
        std::error_code hidden;
        std::vector<std::string> extras;
        if (fs::exists(fs::symlink_status(submission / "extra.cpp", hidden)))
            extras.emplace_back("extra");
        if (fs::is_directory(fs::symlink_status(submission / "extra", hidden)))
            for (const fs::directory_entry& entry : fs::directory_iterator(submission / "extra", hidden))
                if (entry.path().extension() == ".cpp")
                    extras.push_back("extra/" + entry.path().stem().string());
        std::sort(extras.begin(), extras.end());
        extras.resize(std::min(extras.size(), maxExtras));
        std::vector<std::string> names = features;
        names.insert(names.end(), extras.begin(), extras.end());
        return names;
    }

    // Names become words of a compiler's command.
    bool isPlainName(const std::string& name)
    {
        return std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
    }

    Source refuse(const fs::path& source, const std::string& why)
    {
        return { refused(source.filename().string() + ": " + why + "\n"), "", "" };
    }

    std::string whyUntouched(const std::string& name, const std::string& text)
    {
        return isAsHandedOut(name, text) ? name + ".cpp: as it was handed out" : "";
    }

    Source read(const fs::path& submission, const std::string& name)
    {
        const fs::path source = submission / (name + ".cpp");
        if (!isPlainName(source.stem().string()))
            return refuse(source, "its name has characters other than letters, digits and _");
        std::error_code hidden;
        const fs::file_status status = fs::symlink_status(source, hidden);
        if (!fs::exists(status))
            return { {}, "", name + ".cpp: no such file" };
        if (!fs::is_regular_file(status))
            return refuse(source, "not a plain file");
        if (fs::file_size(source, hidden) > maxBytes) // also if there is no telling
            return refuse(source, "larger than a megabyte");
        try {
            const std::string text = files::readText(source);
            return { { State::Taken, "", "" }, text, whyUntouched(name, text) };
        } catch (const files::Error& error) {
            return refuse(source, "cannot be read");
        }
    }

}

Sources readSources(const fs::path& submission)
{
    if (!fs::is_directory(submission))
        throw files::Error(submission, "found no folder, expected one with the files of a submission");
    Sources sources;
    for (const std::string& name : partNames(submission))
        sources[name] = read(submission, name);
    return sources;
}

}
