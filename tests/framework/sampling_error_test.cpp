// What the reference's sampling errs against the truth, as ./raywork bench error measures it.
#include "bench/error_curve.h"
#include <catch2/catch.hpp>
#include <cmath>

using worker::Integrand;
using worker::Strategy;

namespace {

bench::ErrorPoint measure(Integrand integrand, Strategy strategy, uint32_t numSamples, uint32_t numEstimates)
{
    const worker::EstimateRequest request { integrand, strategy, numSamples, numEstimates, numSamples };
    return bench::errorOf(worker::estimate(request), bench::truthsOf(integrand), numSamples);
}

// The error of 1,024 estimates is known to 3 % or so (their squares' deviation is twice their mean), and the slope of a
// line through four of them to 0.01.
double slopeOf(Integrand integrand, Strategy strategy)
{
    std::vector<bench::ErrorPoint> points;
    for (const uint32_t numSamples : { 16u, 64u, 256u, 1024u })
        points.push_back(measure(integrand, strategy, numSamples, 1024));
    return bench::fitSlope(points).value;
}

double gainAt64(Integrand integrand, Strategy strategy)
{
    constexpr uint32_t numEstimates = 16384;
    return bench::gainOver(
        measure(integrand, Strategy::Uniform, 64, numEstimates), measure(integrand, strategy, 64, numEstimates))
        .samples;
}

constexpr Integrand allIntegrands[]
    = { Integrand::Edge, Integrand::AxisEdge, Integrand::SoftShadow, Integrand::Smooth };

}

TEST_CASE("Sampling, the error of uniform samples falls as the root of their number", "[sampling]")
{
    for (const Integrand integrand : allIntegrands)
        CHECK(slopeOf(integrand, Strategy::Uniform) == Approx(-0.5).margin(0.05));
}

TEST_CASE("Sampling, the error of stratified samples falls faster, and fastest where nothing has an edge", "[sampling]")
{
    for (const Integrand integrand : { Integrand::Edge, Integrand::AxisEdge, Integrand::SoftShadow })
        CHECK(slopeOf(integrand, Strategy::Stratified) == Approx(-0.75).margin(0.05));
    CHECK(slopeOf(Integrand::Smooth, Strategy::Stratified) == Approx(-1.0).margin(0.05));
}

TEST_CASE(
    "Sampling, the error of Owen's points falls faster still along an axis and where nothing has an edge", "[sampling]")
{
    for (const Integrand integrand : { Integrand::Edge, Integrand::SoftShadow })
        CHECK(slopeOf(integrand, Strategy::Owen) == Approx(-0.75).margin(0.05));
    CHECK(slopeOf(Integrand::AxisEdge, Strategy::Owen) == Approx(-1.0).margin(0.05));
    CHECK(slopeOf(Integrand::Smooth, Strategy::Owen) < -1.3);
}

TEST_CASE("Sampling, pairs of even numbers help no more than a constant factor with an edge", "[sampling]")
{
    CHECK(slopeOf(Integrand::SoftShadow, Strategy::Pairs) == Approx(-0.5).margin(0.05));
}

TEST_CASE("Sampling, of 64 uniform samples an eighth does when stratified, an eleventh of Owen's points", "[sampling]")
{
    for (const Integrand integrand : { Integrand::Edge, Integrand::SoftShadow }) {
        CHECK(gainAt64(integrand, Strategy::Stratified) >= 8.0);
        CHECK(gainAt64(integrand, Strategy::Owen) >= 11.0);
    }
}

TEST_CASE("Sampling, no strategy errs to one side", "[sampling]")
{
    constexpr uint32_t numEstimates = 4096;
    for (const Integrand integrand : allIntegrands)
        for (const Strategy strategy : { Strategy::Uniform, Strategy::Stratified, Strategy::Owen }) {
            const bench::ErrorPoint point = measure(integrand, strategy, 16, numEstimates);
            // Five deviations of the mean: once in two million by chance, and the seeds are fixed.
            CHECK(std::abs(point.mean) < 5.0 * point.error / std::sqrt(double(numEstimates)));
        }
}
