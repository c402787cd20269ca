#pragma once
#include "worker/estimates.h"
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

// Of a line through the logarithms of number and error, by least squares, and half of its 95 % interval.
struct Slope {
    double value, halfInterval;
};
[[nodiscard]] Slope fitSlope(const std::vector<ErrorPoint>& points);

}
