#pragma once
#include "worker/estimates.h"
#include <optional>
#include <vector>

namespace bench {

// What a strategy errs with one number of samples.
struct ErrorPoint {
    uint32_t numSamples;
    double error; // root mean square
    double mean; // how far all estimates together are from the truth
    double seconds; // an estimate
};

// The truth at the integrand's places, by clipping and quadrature.
[[nodiscard]] std::vector<double> truthsOf(worker::Integrand integrand);

[[nodiscard]] ErrorPoint errorOf(
    const worker::Estimates& estimates, const std::vector<double>& truths, uint32_t numSamples);

// Of a line through the logarithms of number and error, by least squares, and half of its 95 % interval. Of three
// points or more.
struct Slope {
    double value, halfInterval;
};
[[nodiscard]] Slope fitSlope(const std::vector<ErrorPoint>& points);

// How long an estimate takes that errs so much: between measured points along lines in logarithms, empty beyond them.
[[nodiscard]] std::optional<double> secondsToReach(double error, const std::vector<ErrorPoint>& points);

// What uniform samples need more, and err more. Their error is taken to fall as the root of their number, and of their
// time, so that they are not to be measured where others get with few samples.
struct Gain {
    double samples, seconds; // at equal error: uniform's over these
    double error; // at equal time: uniform's over this one
};
[[nodiscard]] Gain gainOver(const ErrorPoint& uniform, const ErrorPoint& point);

}
