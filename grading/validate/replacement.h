#pragma once
#include "files/table_reader.h"
#include <string>

namespace grading {

// The text of reference/<file>.cpp with replacements made all at once, so that two places can swap what stands there.
// pairs: [[from, to], ...], where each `from` stands exactly once. Throws files::Error.
[[nodiscard]] std::string replaced(
    const files::TableReader& table, const files::TomlValue& pairs, const std::string& file, std::string text);

}
