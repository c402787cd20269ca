#include "files/toml_document.h"
#include "files/error.h"
#include "files/text.h"
#include <algorithm>
#include <toml++/toml.h>

namespace files {
namespace {

    // toml++ is slow to compile: nothing beyond this file sees it.
    class Converter {
    public:
        explicit Converter(const std::filesystem::path& path)
            : m_path(path)
        {
        }

        TomlValue convert(const toml::node& node) const
        {
            const auto line = std::max(1, static_cast<int>(node.source().begin.line)); // the top level has none
            return { line, node.visit([&](const auto& kind) { return contentOf(kind); }) };
        }

    private:
        using Content = decltype(TomlValue::content);

        Content contentOf(const toml::table& table) const
        {
            TomlValue::Table entries;
            for (const auto& [key, value] : table) {
                const auto line = static_cast<int>(key.source().begin.line);
                entries.push_back({ std::string(key.str()), convert(value), line });
            }
            std::ranges::stable_sort(entries, {}, &TomlEntry::line); // toml++ has sorted them by name
            return entries;
        }

        Content contentOf(const toml::array& array) const
        {
            TomlValue::Array values;
            for (const toml::node& element : array)
                values.push_back(convert(element));
            return values;
        }

        template <typename T> Content contentOf(const toml::value<T>& value) const
        {
            if constexpr (std::is_constructible_v<Content, T>)
                return value.get();
            else
                throw Error(m_path, static_cast<int>(value.source().begin.line),
                    "found a date or a time, which no setting takes");
        }

        const std::filesystem::path& m_path;
    };

}

TomlValue loadToml(const std::filesystem::path& path)
{
    return parseToml(path, readText(path));
}

TomlValue parseToml(const std::filesystem::path& path, std::string_view text)
{
    try {
        return Converter(path).convert(toml::parse(text));
    } catch (const toml::parse_error& error) {
        throw Error(path, static_cast<int>(error.source().begin.line), std::string(error.description()));
    }
}

}
