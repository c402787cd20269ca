#pragma once
#include "bench/command.h"

namespace bench {

// Times single functions by Google Benchmark, whose flags it takes.
[[nodiscard]] Command declareKernels(CLI::App& cli);

}
