#pragma once
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace report {

// How many points lie in each of cells x cells of the unit square, row by row; points outside are in the nearest one.
[[nodiscard]] std::vector<int> countCells(std::span<const glm::vec2> points, int cells);

// Variance over mean: 0 for equal counts, 1 for those of independent events, more for clumps.
[[nodiscard]] double dispersion(std::span<const int> counts);

// The probability that two sets of points of one size differ as much in their counts in cells x cells of the unit
// square if they come from one distribution. Pearson 1911, "On the Probability that Two Independent Distributions of
// Frequency are Really Samples from the Same Population".
[[nodiscard]] double pValueOfDifference(std::span<const glm::vec2> a, std::span<const glm::vec2> b, int cells);

}
