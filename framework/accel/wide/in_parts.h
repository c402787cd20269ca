#pragma once
#include <cstdint>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

namespace accel::wide {

// What is fewer than this is not worth the time of a second thread.
inline constexpr uint32_t partSize = 1 << 14;

// Adds to a value what all indices below count are worth. addRange(value, begin, end) adds what some are, and
// value.add(other) what others are. The parts are the same for any number of threads.
template <typename Value, typename AddRange> void addInParts(Value& value, uint32_t count, const AddRange& addRange)
{
    if (count <= partSize)
        return addRange(value, 0, count);
    value = tbb::parallel_deterministic_reduce(
        tbb::blocked_range<uint32_t>(0, count, partSize), Value(value),
        [&](const tbb::blocked_range<uint32_t>& part, Value sum) {
            addRange(sum, part.begin(), part.end());
            return sum;
        },
        [](Value sum, const Value& other) {
            sum.add(other);
            return sum;
        });
}

}
