#pragma once
#include "values/stopwatch.h"
#include <algorithm>

namespace bench {

using values::secondsOf;

// The shorter of two times: the first may wait for memory that somebody else had. What is made the second time is kept.
template <typename Made, typename Make> [[nodiscard]] double buildSecondsOf(Made& made, const Make& make)
{
    const auto build = [&] {
        made = {};
        return secondsOf([&] { made = make(); });
    };
    const double first = build();
    return std::min(first, build());
}

}
