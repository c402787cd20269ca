#pragma once
#include <chrono>
#include <utility>

namespace values {

// Runs from when it is made.
class Stopwatch {
public:
    [[nodiscard]] double seconds() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
    }

private:
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

template <typename Work> [[nodiscard]] double secondsOf(Work&& work)
{
    const Stopwatch watch;
    std::forward<Work>(work)();
    return watch.seconds();
}

}
