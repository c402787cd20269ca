#pragma once
#include "grading/probes/shading_case.h"
#include "grading/stress/random.h"
#include <string>
#include <utility>
#include <vector>

// Points to be shaded.
namespace stress {

[[nodiscard]] std::string describe(const grading::ShadingCase& c);

// Light and camera anywhere, also behind the surface, along the normal, opposite each other or in the surface, within a
// few roundings; any shininess and any light.
[[nodiscard]] grading::ShadingCase anyCase(Random& random);

// By hand, with what each is called.
[[nodiscard]] std::vector<std::pair<std::string, grading::ShadingCase>> specialCases();

// Where one model's highlight is brighter by a fiftieth or more.
[[nodiscard]] grading::ShadingCase decidedCase(Random& random, bool phongIsBrighter);

}
