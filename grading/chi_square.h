#pragma once
#include <span>

namespace grading {

// How many standard deviations the counts are from what a fair assignment to equally likely cells gives: well above 0
// for uneven counts, well below for counts too even to be random. Pearson's chi-square, made normal by the cube root of
// Wilson and Hilferty 1931, "The Distribution of Chi-Square".
[[nodiscard]] double unevenness(std::span<const int> counts);

}
