#pragma once
#include "bench/command.h"

namespace bench {

// Sends the same rays, one after the other on one thread, through each rival's tree, and prints rates and ratios.
[[nodiscard]] Command declareTraversal(CLI::App& cli);

}
