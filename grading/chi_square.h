#pragma once
#include <span>
#include <vector>

namespace grading {

// How many standard deviations the counts are from what a fair assignment to equally likely cells gives: well above 0
// for uneven counts, well below for counts too even to be random. Pearson's chi-square, made normal by the cube root of
// Wilson and Hilferty 1931, "The Distribution of Chi-Square".
[[nodiscard]] double unevenness(std::span<const int> counts);

// The same of the counts within each of many groups, whatever all groups together look like.
[[nodiscard]] double unevennessWithin(std::span<const std::vector<int>> groups);

}
