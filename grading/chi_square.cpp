#include "grading/chi_square.h"
#include <cmath>
#include <numeric>

namespace grading {
namespace {

    double chiSquare(std::span<const int> counts)
    {
        const double expected = std::accumulate(counts.begin(), counts.end(), 0.0) / static_cast<double>(counts.size());
        double sum = 0.0;
        for (const int count : counts)
            sum += (count - expected) * (count - expected) / expected;
        return sum;
    }

    double degreesOfFreedom(std::span<const int> counts)
    {
        return static_cast<double>(counts.size()) - 1.0;
    }

    double deviations(double sum, double degrees)
    {
        const double variance = 2.0 / (9.0 * degrees);
        return (std::cbrt(sum / degrees) - (1.0 - variance)) / std::sqrt(variance);
    }

}

double unevenness(std::span<const int> counts)
{
    return deviations(chiSquare(counts), degreesOfFreedom(counts));
}

double unevennessWithin(std::span<const std::vector<int>> groups)
{
    double sum = 0.0;
    double degrees = 0.0;
    for (const std::vector<int>& counts : groups) {
        sum += chiSquare(counts);
        degrees += degreesOfFreedom(counts);
    }
    return deviations(sum, degrees);
}

}
