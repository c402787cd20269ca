#include "grading/validate/replacement.h"
#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <vector>

namespace grading {
namespace {

    const std::string& stringOf(
        const files::TableReader& table, const files::TomlValue& value, std::string_view expected)
    {
        const std::string* string = std::get_if<std::string>(&value.content);
        if (string == nullptr)
            table.failFound(value, expected);
        return *string;
    }

    struct Replacement {
        std::size_t at, length;
        std::string to;
        int line;
    };

    // At the only place of the text where `from` stands.
    Replacement replacementOf(
        const files::TableReader& table, const files::TomlValue& pair, const std::string& file, const std::string& text)
    {
        constexpr std::string_view expected = "a pair of strings ['from', 'to']";
        const auto& both = table.arrayOf(pair, expected);
        if (both.size() != 2)
            table.failFound(pair, expected);
        const std::string& from = stringOf(table, both[0], expected);
        int count = 0;
        std::size_t place = 0;
        for (std::size_t at = 0; !from.empty() && (at = text.find(from, at)) != std::string::npos; at += from.size())
            place = at, ++count;
        if (count != 1)
            table.fail(pair.line,
                fmt::format("found \"{}\" {} times in reference/{}.cpp, expected it once",
                    from.substr(0, from.find('\n')), count, file));
        return { place, from.size(), stringOf(table, both[1], expected), pair.line };
    }

}

std::string replaced(
    const files::TableReader& table, const files::TomlValue& pairs, const std::string& file, std::string text)
{
    std::vector<Replacement> replacements;
    for (const files::TomlValue& pair : table.arrayOf(pairs, "an array of pairs ['from', 'to']"))
        replacements.push_back(replacementOf(table, pair, file, text));
    std::ranges::sort(replacements, std::greater {}, &Replacement::at); // from the back: places stay where they are
    std::size_t end = text.size();
    for (const Replacement& replacement : replacements) {
        if (replacement.at + replacement.length > end)
            table.fail(replacement.line, "found text that another pair replaces too, expected pairs apart");
        text.replace(replacement.at, replacement.length, replacement.to);
        end = replacement.at;
    }
    return text;
}

}
