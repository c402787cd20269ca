#pragma once
#include "bench/command.h"

namespace bench {

// What samples where they are needed save, against as many everywhere, at the same error.
[[nodiscard]] Command declareAdaptive(CLI::App& cli);

}
