#pragma once
#include <chrono>
#include <utility>

namespace bench {

template <typename Work> [[nodiscard]] double secondsOf(Work&& work)
{
    const auto start = std::chrono::steady_clock::now();
    std::forward<Work>(work)();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}
