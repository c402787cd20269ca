#pragma once
#include <cstdint>
#include <glm/vec2.hpp>

namespace values {

// Points of Sobol's sequence in two dimensions, scrambled after Owen 1995: of 2^k points in a row, from a multiple of
// 2^k on, each box of area 2^-k that comes of halving the unit square k times has exactly one, and each point on its
// own is uniform. By hashing, as in Burley 2020, "Practical Hash-based Owen Scrambling".
//
// seed: another one gives other points, in another order. All coordinates are in [0, 1).
[[nodiscard]] glm::vec2 owenSobol(uint32_t index, uint32_t seed);

}
