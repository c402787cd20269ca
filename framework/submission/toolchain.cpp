#include "submission/toolchain.h"
#include "files/error.h"
#include "sandbox/bubblewrap.h"
#include "submission/digest.h"
#include "submission/paths.h"
#include <filesystem>
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

    std::string digestOfOurs()
    {
        Digest digest;
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

}
