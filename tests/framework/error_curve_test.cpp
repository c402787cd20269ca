#include "bench/error_curve.h"
#include <catch2/catch.hpp>
#include <cmath>

using bench::ErrorPoint;

namespace {

// A sample takes a microsecond.
ErrorPoint pointOf(uint32_t numSamples, double error)
{
    return { numSamples, error, 0.0, 1e-6 * numSamples };
}

}

TEST_CASE("The slope of a power law is its exponent, to within nothing", "[bench]")
{
    std::vector<ErrorPoint> points;
    for (const uint32_t numSamples : { 16u, 64u, 256u })
        points.push_back(pointOf(numSamples, 3.0 * std::pow(numSamples, -0.75)));
    const bench::Slope slope = bench::fitSlope(points);
    CHECK(slope.value == Approx(-0.75).epsilon(1e-12)); // a few roundings
    CHECK(slope.halfInterval < 1e-6); // the root of what a difference of roundings leaves
}

TEST_CASE("The interval of a slope is Student's", "[bench]")
{
    // Logarithms to the base 2: (0, 0), (1, -1 + e), (2, -2): the line's slope is -1, and a third of e is how far it
    // passes from the ends. With one degree of freedom the quantile is 12.706.
    const double e = 0.3;
    const std::vector<ErrorPoint> points { pointOf(1, 1.0), pointOf(2, std::exp2(e - 1.0)), pointOf(4, 0.25) };
    const bench::Slope slope = bench::fitSlope(points);
    CHECK(slope.value == Approx(-1.0));
    CHECK(slope.halfInterval == Approx(12.706 * std::sqrt(e * e * 2.0 / 3.0 / 2.0)).epsilon(1e-4)); // its digits
}

TEST_CASE("The time to reach an error lies between measured ones, and is unknown beyond them", "[bench]")
{
    const std::vector<ErrorPoint> points { pointOf(1, 1.0), pointOf(16, 0.25), pointOf(64, 0.125) };
    CHECK(bench::secondsToReach(1.0, points) == 1e-6);
    CHECK(bench::secondsToReach(0.5, points).value() == Approx(4e-6));
    CHECK(bench::secondsToReach(0.125, points).value() == Approx(64e-6));
    CHECK_FALSE(bench::secondsToReach(0.1, points));
    CHECK_FALSE(bench::secondsToReach(2.0, points));
}

TEST_CASE("What errs half as much in half the time saves four times the samples and eight times the time", "[bench]")
{
    const ErrorPoint uniform { 64, 0.2, 0.0, 2e-6 }, other { 64, 0.1, 0.0, 1e-6 };
    const bench::Gain gain = bench::gainOver(uniform, other);
    CHECK(gain.samples == Approx(4.0));
    CHECK(gain.seconds == Approx(8.0));
    CHECK(gain.error == Approx(std::sqrt(8.0)));
}
