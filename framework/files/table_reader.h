#pragma once
#include "files/toml_document.h"
#include <cfloat>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string_view>

namespace files {

// The finite numbers that a setting takes, with a name for messages.
struct Range {
    float lowest, highest;
    std::string_view name;
};

inline constexpr Range anyNumber { -FLT_MAX, FLT_MAX, "a number" };
inline constexpr Range fraction { 0.0f, 1.0f, "a number in [0, 1]" };
inline constexpr Range notNegative { 0.0f, FLT_MAX, "a number of at least 0" };
inline constexpr Range positive { FLT_MIN, FLT_MAX, "a number above 0" };

// What a value says, for messages: 1.5, "phong", an array of 2, a table.
[[nodiscard]] std::string shown(const TomlValue& value);

// Reads a table of a TOML file key by key. Each read remembers its key, so that finish() knows which are allowed.
// All throw Error with the line of the value.
class TableReader {
public:
    TableReader(const std::filesystem::path& path, const TomlValue& value);

    // These leave the target as it is if the key is missing, and return whether it is there.
    bool read(std::string_view key, bool& target);
    bool read(std::string_view key, std::string& target);
    bool read(std::string_view key, float& target, const Range& range = anyNumber);
    bool read(std::string_view key, glm::vec3& target, const Range& range = anyNumber); // of each of the three
    bool read(std::string_view key, glm::ivec2& target, int lowest, int highest);

    // The value of the key, null if it is missing.
    [[nodiscard]] const TomlValue* find(std::string_view key);

    // The tables of [[key]]; none if the key is missing.
    [[nodiscard]] std::vector<TableReader> readTables(std::string_view key);

    template <typename... Arguments> void require(std::string_view key, Arguments&&... arguments)
    {
        if (!read(key, arguments...))
            m_missing.push_back(key);
    }

    // Throws for a key that nobody read, then for one that is required and missing.
    void finish() const;

    [[nodiscard]] glm::vec3 vectorOf(const TomlValue& value, const Range& range = anyNumber) const;
    [[nodiscard]] const TomlValue::Array& arrayOf(const TomlValue& value, std::string_view expected) const;

    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }
    [[nodiscard]] const TomlValue::Table& entries() const { return *m_entries; }
    [[nodiscard]] int line() const { return m_line; }

    [[noreturn]] void fail(int line, const std::string& message) const;
    [[noreturn]] void failFound(const TomlValue& value, std::string_view expected) const;

private:
    [[nodiscard]] float numberOf(const TomlValue& value, const Range& range) const;

    std::filesystem::path m_path;
    const TomlValue::Table* m_entries;
    int m_line;
    std::vector<std::string_view> m_known, m_missing;
};

}
