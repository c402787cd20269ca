#pragma once
#include "adaptive/render.h"
#include <string>

namespace app {

// From what --error and --time say; an empty one is no goal. Throws std::invalid_argument.
[[nodiscard]] adaptive::Goal parseGoal(const std::string& error, const std::string& time);

}
