#pragma once
#include "grading/stress/judgement.h"
#include "grading/stress/text.h"
#include <cmath>
#include <glm/common.hpp>

namespace stress {

inline constexpr double ulpOfOne = std::numeric_limits<float>::epsilon(); // two roundings of a number of about 1
inline constexpr double leastFloat = std::numeric_limits<float>::denorm_min(); // what underflow may lose

// How far came is from expected, in ulps of the condition: the size of the largest numbers that had to be rounded on
// the way, channel by channel. NaN where came is NaN.
template <int N>
[[nodiscard]] double ulpsBetween(
    const glm::vec<N, float>& came, const glm::vec<N, double>& expected, const glm::vec<N, double>& condition)
{
    double most = 0.0;
    for (int i = 0; i < N; ++i) {
        const double error = std::abs(static_cast<double>(came[i]) - expected[i]);
        const double ulps = error / (ulpOfOne * condition[i] + leastFloat);
        if (!(ulps <= most))
            most = ulps;
        if (std::isnan(most))
            return most;
    }
    return most;
}

template <int N>
[[nodiscard]] Judgement judgeUlps(const glm::vec<N, float>& came, const glm::vec<N, double>& expected,
    const glm::vec<N, double>& condition, double bound)
{
    const double ulps = ulpsBetween(came, expected, condition);
    return ulps <= bound
        ? right(ulps)
        : wrong(exactly(came), fmt::format("{} within {:.3g} ulps of {}", exactly(expected), bound, exactly(condition)),
            ulps);
}

// Each channel in [lower, upper]; what is infinite or NaN never is.
template <int N>
[[nodiscard]] Judgement judgeInside(
    const glm::vec<N, float>& came, const glm::vec<N, double>& lower, const glm::vec<N, double>& upper)
{
    for (int i = 0; i < N; ++i) {
        const auto value = static_cast<double>(came[i]);
        if (!(std::isfinite(came[i]) && value >= lower[i] && value <= upper[i]))
            return wrong(exactly(came), fmt::format("finite, from {} to {}", exactly(lower), exactly(upper)));
    }
    return right();
}

// The float that is so many steps above x, or below.
[[nodiscard]] inline float stepped(float x, int steps)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (; steps > 0; --steps)
        x = std::nextafter(x, infinity);
    for (; steps < 0; ++steps)
        x = std::nextafter(x, -infinity);
    return x;
}

}
