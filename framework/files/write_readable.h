#pragma once
#include "files/toml_document.h"
#include <functional>

namespace files {

// Writes the document, or, throwing Error, leaves what was there: it cannot be written, or `read` refuses what it would
// find there by throwing an Error.
void writeReadable(const std::filesystem::path& to, const TomlValue::Table& document,
    const std::function<void(const TomlValue&)>& read);

}
