#include "adaptive/believed_errors.h"
#include "sampler.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

using adaptive::Estimate;

namespace {

constexpr uint32_t fewestRays = 8;

// Pixels whose rays are white with the pixel's chance, independently, and black otherwise.
class Coins {
public:
    Coins(std::vector<double> chances, int width, uint32_t seed)
        : m_chances(std::move(chances))
        , m_width(width)
        , m_sampler(seed)
    {
        for (const double chance : m_chances)
            m_estimates.push_back(adaptive::estimateFrom(
                { toss(chance, 2), toss(chance, 2), toss(chance, 2), toss(chance, 2) }, fewestRays));
    }

    // Until none is believed to err by more. Returns what they are believed to err by.
    std::vector<double> refine(double error)
    {
        for (;;) {
            const std::vector<double> errors = believed();
            if (std::ranges::none_of(errors, [&](double e) { return e > error; }))
                return errors;
            for (std::size_t i = 0; i < errors.size(); ++i) {
                const uint32_t half = m_estimates[i].numRays / 2;
                if (errors[i] > error)
                    m_estimates[i] = doubled(m_estimates[i], { toss(m_chances[i], half), toss(m_chances[i], half) });
            }
        }
    }

    [[nodiscard]] double squaredError(std::size_t i) const
    {
        return std::pow(m_estimates[i].mean().x - m_chances[i], 2.0);
    }

private:
    [[nodiscard]] std::vector<double> believed() const
    {
        return believedErrors(m_estimates, { m_width, static_cast<int>(m_chances.size()) / m_width });
    }

    glm::dvec3 toss(double chance, uint32_t number)
    {
        double sum = 0.0;
        for (uint32_t i = 0; i < number; ++i)
            sum += static_cast<double>(m_sampler.next_1d()) < chance;
        return glm::dvec3(sum / number);
    }

    std::vector<double> m_chances;
    int m_width;
    Sampler m_sampler;
    std::vector<Estimate> m_estimates;
};

// Black and white with an edge between them, as wide as a pixel.
std::vector<double> slantingEdge(int side)
{
    std::vector<double> chances;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            chances.push_back(std::clamp(x - 0.3 * y - 0.2 * side, 0.0, 1.0));
    return chances;
}

Estimate flat(double color, uint32_t numRays)
{
    const glm::dvec3 c(color);
    return adaptive::estimateFrom({ c, c, c, c }, numRays);
}

}

TEST_CASE("Where sampling stops as the error is believed small enough, it is not larger, also of independent samples",
    "[adaptive]")
{
    constexpr int side = 24;
    for (const double error : { 0.1, 0.05, 0.025 }) {
        double believed = 0.0, real = 0.0;
        for (uint32_t seed = 0; seed < 20; ++seed) {
            Coins coins(slantingEdge(side), side, seed);
            const std::vector<double> errors = coins.refine(error);
            for (std::size_t i = 0; i < errors.size(); ++i) {
                believed += errors[i] * errors[i];
                real += coins.squaredError(i);
            }
        }
        CAPTURE(error, std::sqrt(real / believed));
        CHECK(std::sqrt(real) <= 1.1 * std::sqrt(believed)); // what is promised
        CHECK(std::sqrt(real) >= 0.8 * std::sqrt(believed)); // and believing too much costs samples
    }
}

TEST_CASE("Quarters that agree leave no error, whatever their number, and their mean does not drift", "[adaptive]")
{
    Estimate estimate = flat(0.1, fewestRays);
    while (estimate.numRays < 1u << 20)
        estimate = doubled(estimate, { glm::dvec3(0.1), glm::dvec3(0.1) });
    CHECK(estimate.numRays == 1u << 20);
    CHECK(estimate.mean() == glm::dvec3(0.1)); // exactly
    CHECK(estimate.variance == 0.0);
}

TEST_CASE("Every ray weighs the same in the mean, whichever round it came in", "[adaptive]")
{
    const auto c = [](double value) { return glm::dvec3(value); };
    const Estimate first = adaptive::estimateFrom({ c(0.0), c(0.25), c(0.5), c(0.75) }, 8);
    CHECK(first.mean() == c(0.375));
    const Estimate both = doubled(first, { c(1.0), c(0.5) }); // of eight more rays
    CHECK(both.mean() == c(0.5 * 0.375 + 0.5 * 0.75));
    CHECK(both.numRays == 16);
    // The quarters are 0.125, 0.625, 1, 0.5, their mean 0.5625; the sum of squared deviations over 3 * 4.
    CHECK(both.variance == Approx((0.4375 * 0.4375 + 2 * 0.0625 * 0.0625 + 0.4375 * 0.4375) / 12.0).epsilon(1e-12));
}

TEST_CASE("What the picture cannot show is no error", "[adaptive]")
{
    const auto around = [](double mean) {
        return adaptive::estimateFrom(
            { glm::dvec3(mean - 0.1), glm::dvec3(mean + 0.1), glm::dvec3(mean - 0.1), glm::dvec3(mean + 0.1) }, 8)
            .variance;
    };
    CHECK(around(0.5) > 0.0);
    CHECK(around(1.0) == Approx(around(0.5))); // half of the time it is off by as much
    CHECK(around(2.0) == 0.0);
    CHECK(around(-1.0) == 0.0);
}

TEST_CASE("A colour that is no number asks for no more samples, and leaves its neighbours alone", "[adaptive]")
{
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    for (const double value : { nan, infinity }) {
        std::vector<Estimate> estimates(9, flat(0.5, 8));
        estimates[4] = adaptive::estimateFrom({ glm::dvec3(value), {}, {}, {} }, 8);
        for (const double error : adaptive::believedErrors(estimates, { 3, 3 }))
            CHECK(error == 0.0);
    }
}

TEST_CASE("A pixel is believed no more than its neighbours allow, to the picture's corners", "[adaptive]")
{
    std::vector<Estimate> estimates(12, flat(0.5, 8));
    estimates[0].variance = 0.01;
    const std::vector<double> errors = adaptive::believedErrors(estimates, { 4, 3 });
    CHECK(errors[0] * errors[0] == Approx(0.01 * 4.0 / 9.0)); // of the four pixels around: 4, 2, 2, 1
    CHECK(errors[1] * errors[1] == Approx(0.01 * 2.0 / 12.0));
    CHECK(errors[5] * errors[5] == Approx(0.01 / 16.0));
    CHECK(errors[2] == 0.0);
    CHECK(errors[11] == 0.0);
    estimates[0].numRays = 32; // with a fourth of them it would have eight times the variance
    CHECK(adaptive::believedErrors(estimates, { 4, 3 })[5] == Approx(std::sqrt(0.08 / 16.0)));
}
