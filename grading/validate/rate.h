#pragma once
#include <cstddef>

namespace grading {

// The largest rate that is not refuted, at 95 %, by `count` cases in `total` independent trials: one-sided bound of
// Clopper and Pearson 1934. Without any case that is 1 - 0.05^(1 / total), about 3 / total.
[[nodiscard]] double upperBoundOfRate(std::size_t count, std::size_t total);

}
