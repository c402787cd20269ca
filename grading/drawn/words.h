#pragma once
#include "grading/drawn/place.h"
#include <vector>

namespace grading {

// The drawing in words that two drawings can be compared by: a line for all of a kind at places of a kind, such as
// "3 rays along the normal, yellow, 0.2 long"; "nothing" where there are none.
[[nodiscard]] std::vector<std::string> inWords(const Surroundings& surroundings);

}
