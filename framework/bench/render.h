#pragma once
#include "bench/command.h"

namespace bench {

// Whole frames, and the library's traversal of their rays alone.
[[nodiscard]] Command declareRender(CLI::App& cli);

}
