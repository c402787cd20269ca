#include "submission/sources.h"
#include "files/error.h"
#include "files/text.h"
#include "submission/features.h"
#include <algorithm>
#include <cctype>
#include <vector>

namespace submission {
namespace {

    namespace fs = std::filesystem;

    constexpr std::uintmax_t maxBytes = 1 << 20; // the largest file of a real submission has a tenth of that

    // The files that the interface names, whether they are there or not.
    std::vector<std::string> partNames(const fs::path& submission)
    {
        std::vector<std::string> names = features;
        if (fs::exists(submission / "extra.cpp"))
            names.emplace_back("extra");
        if (fs::is_directory(fs::symlink_status(submission / "extra")))
            for (const fs::directory_entry& entry : fs::directory_iterator(submission / "extra"))
                if (entry.path().extension() == ".cpp")
                    names.push_back("extra/" + entry.path().stem().string());
        return names;
    }

    // Names become words of a compiler's command.
    bool isPlainName(const std::string& name)
    {
        return std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
    }

    Source refuse(const fs::path& source, const std::string& why)
    {
        return { refused(source.filename().string() + ": " + why + "\n"), "" };
    }

    Source read(const fs::path& source)
    {
        if (!isPlainName(source.stem().string()))
            return refuse(source, "its name has characters other than letters, digits and _");
        const fs::file_status status = fs::symlink_status(source);
        if (!fs::exists(status))
            return {};
        if (!fs::is_regular_file(status))
            return refuse(source, "not a plain file");
        if (fs::file_size(source) > maxBytes)
            return refuse(source, "larger than a megabyte");
        return { { State::Taken, "", "" }, files::readText(source) };
    }

}

Sources readSources(const fs::path& submission)
{
    if (!fs::is_directory(submission))
        throw files::Error(submission, "found no folder, expected one with the files of a submission");
    Sources sources;
    for (const std::string& name : partNames(submission))
        sources[name] = read(submission / (name + ".cpp"));
    return sources;
}

}
