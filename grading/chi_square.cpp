#include "grading/chi_square.h"
#include <cmath>
#include <numeric>

namespace grading {

double unevenness(std::span<const int> counts)
{
    const double expected = std::accumulate(counts.begin(), counts.end(), 0.0) / static_cast<double>(counts.size());
    double chiSquare = 0.0;
    for (const int count : counts)
        chiSquare += (count - expected) * (count - expected) / expected;
    const double degrees = static_cast<double>(counts.size()) - 1.0;
    const double variance = 2.0 / (9.0 * degrees);
    return (std::cbrt(chiSquare / degrees) - (1.0 - variance)) / std::sqrt(variance);
}

}
