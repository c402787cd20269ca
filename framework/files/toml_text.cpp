#include "files/toml_text.h"
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>

namespace files {
namespace {

    std::string inQuotes(std::string_view text)
    {
        std::string result = "\"";
        for (const char c : text) {
            if (c == '"' || c == '\\')
                result.append({ '\\', c });
            else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
                std::array<char, 8> escaped;
                std::snprintf(escaped.data(), escaped.size(), "\\u%04X", static_cast<unsigned>(c));
                result += escaped.data();
            } else
                result += c;
        }
        return result + '"';
    }

    std::string shownKey(const std::string& key)
    {
        constexpr std::string_view bare = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";
        return !key.empty() && key.find_first_not_of(bare) == std::string::npos ? key : inQuotes(key);
    }

    std::string textOf(const TomlValue& value);

    std::string textOf(bool value)
    {
        return value ? "true" : "false";
    }
    std::string textOf(int64_t value)
    {
        return std::to_string(value);
    }
    std::string textOf(const std::string& value)
    {
        return inQuotes(value);
    }

    // The shortest text that denotes the same double.
    std::string textOf(double value)
    {
        std::array<char, 32> digits;
        const std::string text(digits.data(), std::to_chars(digits.begin(), digits.end(), value).ptr);
        const bool looksIntegral = text.find_first_not_of("-0123456789") == std::string::npos;
        return looksIntegral ? text + ".0" : text;
    }

    std::string textOf(const TomlValue::Array& array)
    {
        std::string text;
        for (const TomlValue& element : array)
            text.append(text.empty() ? "" : ", ").append(textOf(element));
        return "[" + text + "]";
    }

    std::string textOf(const TomlValue::Table& table)
    {
        std::string text;
        for (const TomlEntry& entry : table)
            text.append(text.empty() ? " " : ", ").append(shownKey(entry.key) + " = ").append(textOf(entry.value));
        return "{" + text + " }";
    }

    std::string textOf(const TomlValue& value)
    {
        return std::visit([](const auto& content) { return textOf(content); }, value.content);
    }

    template <typename Kind> bool areAll(const TomlValue& value)
    {
        const auto* array = std::get_if<TomlValue::Array>(&value.content);
        const auto isOfKind = [](const TomlValue& element) { return std::holds_alternative<Kind>(element.content); };
        return array != nullptr && !array->empty() && std::ranges::all_of(*array, isOfKind);
    }

    // A list of polygons may be long: each has a line.
    std::string lineOf(const TomlEntry& entry)
    {
        std::string text = shownKey(entry.key) + " = ";
        if (!areAll<TomlValue::Array>(entry.value))
            return text + textOf(entry.value) + '\n';
        text += "[\n";
        for (const TomlValue& element : std::get<TomlValue::Array>(entry.value.content))
            text.append("    ").append(textOf(element)).append(",\n");
        return text + "]\n";
    }

    std::string linesOf(const TomlValue& table)
    {
        std::string text;
        for (const TomlEntry& entry : std::get<TomlValue::Table>(table.content))
            text += lineOf(entry);
        return text;
    }

    std::string sectionsOf(const TomlEntry& entry)
    {
        if (std::holds_alternative<TomlValue::Table>(entry.value.content))
            return "\n[" + shownKey(entry.key) + "]\n" + linesOf(entry.value);
        std::string text;
        for (const TomlValue& table : std::get<TomlValue::Array>(entry.value.content))
            text += "\n[[" + shownKey(entry.key) + "]]\n" + linesOf(table);
        return text;
    }

    bool isSection(const TomlEntry& entry)
    {
        return std::holds_alternative<TomlValue::Table>(entry.value.content) || areAll<TomlValue::Table>(entry.value);
    }

}

std::string tomlText(const TomlValue::Table& document)
{
    std::string lines, sections; // what stands below a header belongs to it, so the lines of the top come first
    for (const TomlEntry& entry : document)
        if (isSection(entry))
            sections += sectionsOf(entry);
        else
            lines += lineOf(entry);
    return lines + sections;
}

}
