#pragma once
#include "files/toml_document.h"

namespace files {

// The text of a document, from which parseToml makes the same values.
[[nodiscard]] std::string tomlText(const TomlValue::Table& document);

}
