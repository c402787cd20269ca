#pragma once
#include "grading/stress/probes/lookup.h"
#include "grading/stress/random.h"
#include <string>
#include <utility>
#include <vector>

// Where textures are looked up.
namespace stress {

// At and beside borders and centres of texels, in between, and far outside.
[[nodiscard]] Lookup anywhere(Random& random);

// At the centre of a texel, where both sizes are powers of two.
[[nodiscard]] Lookup exactCentre(Random& random);

// Coordinates and sizes that break lookups, with what each is called.
[[nodiscard]] std::vector<std::pair<std::string, Lookup>> specialLookups();

}
