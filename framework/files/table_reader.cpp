#include "files/table_reader.h"
#include "files/error.h"
#include <algorithm>
#include <framework/variant_helper.h>
#include <sstream>

namespace files {

std::string shown(const TomlValue& value)
{
    std::ostringstream text;
    std::visit(make_visitor([&](bool b) { text << (b ? "true" : "false"); }, [&](int64_t i) { text << i; },
                   [&](double d) { text << d; }, [&](const std::string& s) { text << '"' << s << '"'; },
                   [&](const TomlValue::Array& array) { text << "an array of " << array.size(); },
                   [&](const TomlValue::Table&) { text << "a table"; }),
        value.content);
    return text.str();
}

TableReader::TableReader(const std::filesystem::path& path, const TomlValue& value)
    : m_path(path)
    , m_entries(std::get_if<TomlValue::Table>(&value.content))
    , m_line(value.line)
{
    if (m_entries == nullptr)
        failFound(value, "a table");
}

const TomlValue* TableReader::find(std::string_view key)
{
    if (std::ranges::find(m_known, key) == m_known.end())
        m_known.push_back(key);
    const auto entry = std::ranges::find(*m_entries, key, &TomlEntry::key);
    return entry == m_entries->end() ? nullptr : &entry->value;
}

bool TableReader::read(std::string_view key, bool& target)
{
    const TomlValue* value = find(key);
    if (value == nullptr)
        return false;
    const bool* found = std::get_if<bool>(&value->content);
    if (found == nullptr)
        failFound(*value, "true or false");
    target = *found;
    return true;
}

bool TableReader::read(std::string_view key, std::string& target)
{
    const TomlValue* value = find(key);
    if (value == nullptr)
        return false;
    const std::string* found = std::get_if<std::string>(&value->content);
    if (found == nullptr || found->empty())
        failFound(*value, "a name in quotes");
    target = *found;
    return true;
}

bool TableReader::read(std::string_view key, float& target, const Range& range)
{
    const TomlValue* value = find(key);
    if (value != nullptr)
        target = numberOf(*value, range);
    return value != nullptr;
}

bool TableReader::read(std::string_view key, glm::vec3& target, const Range& range)
{
    const TomlValue* value = find(key);
    if (value != nullptr)
        target = vectorOf(*value, range);
    return value != nullptr;
}

bool TableReader::read(std::string_view key, glm::ivec2& target, int lowest, int highest)
{
    const TomlValue* value = find(key);
    if (value == nullptr)
        return false;
    const std::string expected = "integers from " + std::to_string(lowest) + " to " + std::to_string(highest);
    const TomlValue::Array& array = arrayOf(*value, "an array of 2 " + expected);
    if (array.size() != 2)
        failFound(*value, "an array of 2 " + expected);
    for (int i = 0; i < 2; ++i) {
        const TomlValue& element = array[static_cast<std::size_t>(i)];
        const int64_t* found = std::get_if<int64_t>(&element.content);
        if (found == nullptr || *found < lowest || *found > highest)
            failFound(element, expected);
        target[i] = static_cast<int>(*found);
    }
    return true;
}

std::vector<TableReader> TableReader::readTables(std::string_view key)
{
    std::vector<TableReader> tables;
    if (const TomlValue* value = find(key))
        for (const TomlValue& element : arrayOf(*value, "tables [[" + std::string(key) + "]]"))
            tables.emplace_back(m_path, element);
    return tables;
}

void TableReader::finish() const
{
    std::string expected;
    for (const std::string_view key : m_known)
        expected.append(expected.empty() ? "" : ", ").append(key);
    for (const TomlEntry& entry : *m_entries)
        if (std::ranges::find(m_known, entry.key) == m_known.end())
            fail(entry.line, "found the unknown key \"" + entry.key + "\", expected one of " + expected);
    if (!m_missing.empty()) // last: that another key is misspelt says more
        fail(m_line, "found no " + std::string(m_missing.front()) + ", expected one");
}

float TableReader::numberOf(const TomlValue& value, const Range& range) const
{
    float number = 0.0f; // as the limits are: a double may lie beyond one and yet round to it
    if (const int64_t* integer = std::get_if<int64_t>(&value.content))
        number = static_cast<float>(*integer);
    else if (const double* real = std::get_if<double>(&value.content))
        number = static_cast<float>(*real);
    else
        failFound(value, range.name);
    if (!(number >= range.lowest && number <= range.highest)) // so that NaN fails
        failFound(value, range.name);
    return number;
}

glm::vec3 TableReader::vectorOf(const TomlValue& value, const Range& range) const
{
    const std::string expected = "an array of 3, each " + std::string(range.name);
    const TomlValue::Array& array = arrayOf(value, expected);
    if (array.size() != 3)
        failFound(value, expected);
    return { numberOf(array[0], range), numberOf(array[1], range), numberOf(array[2], range) };
}

const TomlValue::Array& TableReader::arrayOf(const TomlValue& value, std::string_view expected) const
{
    const auto* array = std::get_if<TomlValue::Array>(&value.content);
    if (array == nullptr)
        failFound(value, expected);
    return *array;
}

void TableReader::fail(int line, const std::string& message) const
{
    throw Error(m_path, line, message);
}

void TableReader::failFound(const TomlValue& value, std::string_view expected) const
{
    fail(value.line, "found " + shown(value) + ", expected " + std::string(expected));
}

}
