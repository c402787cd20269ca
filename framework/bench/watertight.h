#pragma once
#include "bench/command.h"

namespace bench {

// Sends rays from inside closed meshes at their corners and at points of their edges, meshes of several sizes and far
// from the origin among them, and prints how many each rival lets through.
[[nodiscard]] Command declareWatertight(CLI::App& cli);

}
