#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace files {

struct TomlEntry;

// A value of a TOML file that knows its line; of a table, that of its header.
struct TomlValue {
    using Array = std::vector<TomlValue>;
    using Table = std::vector<TomlEntry>;

    int line = 1;
    std::variant<bool, int64_t, double, std::string, Array, Table> content;
};

struct TomlEntry {
    std::string key;
    TomlValue value;
    int line = 1; // of the key
};

// The top-level table; the entries of tables come in the order of their lines. Throws Error.
[[nodiscard]] TomlValue loadToml(const std::filesystem::path& path);

// The same of a text, which errors name as the path.
[[nodiscard]] TomlValue parseToml(const std::filesystem::path& path, std::string_view text);

}
