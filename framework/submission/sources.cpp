#include "submission/sources.h"
#include "files/error.h"
#include "files/text.h"
#include "submission/features.h"
#include <algorithm>
#include <cctype>
#include <fstream>
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

    // Names go to a shell and into a file of Ninja's.
    bool isPlainName(const std::string& name)
    {
        return std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
    }

    Part refused(const fs::path& source, const std::string& why)
    {
        return { State::Refused, source.filename().string() + ": " + why + "\n", "" };
    }

    Part inspect(const fs::path& source)
    {
        if (!isPlainName(source.stem().string()))
            return refused(source, "its name has characters other than letters, digits and _");
        const fs::file_status status = fs::symlink_status(source);
        if (!fs::exists(status))
            return { State::Missing, "", "" };
        if (!fs::is_regular_file(status))
            return refused(source, "not a plain file");
        if (fs::file_size(source) > maxBytes)
            return refused(source, "larger than a megabyte");
        return { State::Taken, "", "" };
    }

    void update(const fs::path& destination, const std::string& text)
    {
        if (fs::exists(destination) && files::readText(destination) == text)
            return; // the same file with the same time: nothing is built again
        fs::create_directories(destination.parent_path());
        std::ofstream(destination, std::ios::binary) << text;
    }

}

Parts takeSources(const fs::path& submission, const fs::path& destination)
{
    if (!fs::is_directory(submission))
        throw files::Error(submission, "found no folder, expected one with the files of a submission");
    Parts parts;
    for (const std::string& name : partNames(submission)) {
        const fs::path source = submission / (name + ".cpp");
        const fs::path copy = destination / (name + ".cpp");
        const Part part = inspect(source);
        if (part.state == State::Taken)
            update(copy, files::readText(source));
        else
            fs::remove(copy);
        parts[name] = part;
    }
    return parts;
}

}
