#pragma once
#include "grading/validate/bank.h"

namespace grading {

// `wrong` of the wrong solutions and half as many of the accepted ones, spread evenly over the bank: number
// floor(i * all / wanted) for i = 0, 1, ... All where there are fewer.
[[nodiscard]] Bank sampleOf(const Bank& bank, std::size_t wrong);

}
