#include "submission/toolchain.h"
#include "files/digest.h"
#include "files/error.h"
#include "sandbox/bubblewrap.h"
#include "submission/is_below.h"
#include "submission/paths.h"
#include <algorithm>
#include <toml++/toml.h>

namespace submission {
namespace {

    namespace fs = std::filesystem;

    const toml::table& rules()
    {
        static const toml::table table = toml::parse_file((fs::path(buildDirectory) / "rules.toml").string());
        return table;
    }

    std::vector<std::string> words(const std::string& name)
    {
        const toml::array* const array = rules()[name].as_array();
        if (!array)
            throw files::Error(fs::path(buildDirectory) / "rules.toml", "found no " + name);
        std::vector<std::string> found;
        for (const toml::node& word : *array)
            if (std::string text = word.value_or<std::string>(""); !text.empty())
                found.push_back(std::move(text));
        return found;
    }

    // Programs and libraries below /usr are seen anyway, and of the framework the interface alone.
    std::vector<fs::path> foldersElsewhere(const std::vector<std::string>& compile)
    {
        std::vector<fs::path> folders { fs::canonical(compile.front()).parent_path().parent_path() };
        for (const std::string& word : compile)
            if (word.starts_with("-I"))
                folders.emplace_back(word.substr(2));
        std::erase_if(folders, [](const fs::path& folder) {
            return isBelow(folder, "/usr") || folder == fs::path(sourceDirectory) / "framework" || !fs::exists(folder);
        });
        return folders;
    }

    std::string digestOfOurs()
    {
        files::Digest digest;
        const fs::path compiler = fs::canonical(words("compile").front());
        digest.add(std::to_string(fs::file_size(compiler)));
        digest.add(std::to_string(fs::last_write_time(compiler).time_since_epoch().count()));
        digest.addFile(fs::path(buildDirectory) / "rules.toml");
        digest.addFolder(fs::path(sourceDirectory) / "framework", ".h");
        for (const std::string& file : words("built"))
            digest.addFile(file);
        // Where nothing is locked in, a submission may include what it should not, which is then told by name.
        return digest.add(sandbox::whyNoBubblewrap().empty() ? "locked in" : "at large").hex();
    }

}

Toolchain::Toolchain()
    : compile(words("compile"))
    , link(words("link"))
    , symbols(words("symbols"))
    , folders(foldersElsewhere(compile))
    , digest(digestOfOurs())
{
}

const Toolchain& Toolchain::get()
{
    static const Toolchain toolchain;
    return toolchain;
}

std::vector<std::string> Toolchain::restOf(const std::string& rest) const
{
    return words("rest_" + rest);
}

std::string Toolchain::digestOfRest(const std::string& rest) const
{
    const std::vector<std::string> known = words("built");
    files::Digest rests;
    for (const std::string& file : restOf(rest))
        if (file.starts_with(buildDirectory) && std::ranges::find(known, file) == known.end())
            rests.addFile(file);
    return rests.hex();
}

}
