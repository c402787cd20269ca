#pragma once
#include "bench/command.h"

namespace bench {

// What the library's traversals find, against a search of all triangles in double precision.
[[nodiscard]] Command declareAccuracy(CLI::App& cli);

}
