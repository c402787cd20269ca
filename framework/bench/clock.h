#pragma once
#include "values/stopwatch.h"
#include <algorithm>

namespace bench {

using values::secondsOf;

// The shorter of two times: the first may wait for memory that somebody else had.
template <typename Build> [[nodiscard]] double buildSecondsOf(const Build& build)
{
    const double first = secondsOf(build);
    return std::min(first, secondsOf(build));
}

}
