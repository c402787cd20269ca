#pragma once
#include "adaptive/estimate.h"
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace adaptive {

// The error that each pixel's mean is believed to have, root mean square over its channels as they are shown. Few
// samples of one pixel may agree by chance, where an edge passes: its neighbours have a say.
[[nodiscard]] std::vector<double> believedErrors(std::span<const Estimate> estimates, glm::ivec2 size);

}
