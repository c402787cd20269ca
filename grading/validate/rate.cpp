#include "grading/validate/rate.h"
#include <cmath>

namespace grading {
namespace {

    // The probability of at most `count` cases in `total`, each with probability `rate` in (0, 1).
    double atMost(std::size_t count, std::size_t total, double rate)
    {
        const auto n = static_cast<double>(total);
        double sum = 0.0;
        for (std::size_t i = 0; i <= count; ++i) {
            const auto k = static_cast<double>(i);
            const double logChoices = std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0);
            sum += std::exp(logChoices + k * std::log(rate) + (n - k) * std::log1p(-rate));
        }
        return sum;
    }

}

double upperBoundOfRate(std::size_t count, std::size_t total)
{
    if (count >= total)
        return 1.0;
    double low = 0.0;
    double high = 1.0;
    for (int bit = 0; bit < 50; ++bit) { // halves the interval: far below what is printed
        const double middle = 0.5 * (low + high);
        (atMost(count, total, middle) > 0.05 ? low : high) = middle;
    }
    return high;
}

}
