#pragma once
#include "bench/command.h"

namespace bench {

// Run time against error of a submission's sampling, where the truth is known.
[[nodiscard]] Command declareError(CLI::App& cli);

}
