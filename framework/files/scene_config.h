#pragma once
#include "config.h"
#include "files/table_reader.h"

namespace files {

// The size, [camera] and [features] of a scene file. Throws Error.
[[nodiscard]] Config readConfig(TableReader& top);

}
