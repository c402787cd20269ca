#pragma once
#include "shapes/bezier_patch.h"
#include <vector>

namespace shapes {

// The 32 patches of the Utah teapot in Newell's measures, +y up, the spout along +x, the bottom at y = 0; the
// derivative by u cross that by v points outwards.
[[nodiscard]] std::vector<BezierPatch> teapotPatches();

}
