#pragma once
#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace grading {

// The places of a pixel's rays in the unit square, in the order of the rays.
using Places = std::vector<glm::dvec2>;

// How many places are in each of columns x rows equal cells of the unit square, row by row.
[[nodiscard]] std::vector<int> countCells(const Places& places, int columns, int rows);

// Throws Wrong unless the places, 16 for each of several hundred pixels, are what independent uniform random numbers
// give. A right submission fails with probability 4e-7.
void expectIndependent(const std::string& asked, const std::vector<Places>& pixels);

}
