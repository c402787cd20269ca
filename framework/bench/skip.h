#pragma once
#include "bench/command.h"

namespace bench {

// Whole frames with and without what their scenes do not need, and by code specialised for it.
[[nodiscard]] Command declareSkip(CLI::App& cli);

}
