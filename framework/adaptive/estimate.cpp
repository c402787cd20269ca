#include "adaptive/estimate.h"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace adaptive {
namespace {

    using Quarters = std::array<double, 4>;

    double shown(double value)
    {
        return std::clamp(value, 0.0, 1.0);
    }

    // What is left of a deviation where the picture ends at 0 and 1, at worst.
    double shownDeviation(double mean, double deviation)
    {
        constexpr double reach = 3.0; // deviations that a mean strays, seldom further
        const double up = shown(mean + reach * deviation) - shown(mean);
        const double down = shown(mean) - shown(mean - reach * deviation);
        return std::max(up, down) / reach;
    }

    // Of the quarters' mean, as if they were independent. Quarters of evenly spread samples complement each other, so
    // that they differ more than their mean errs: by half as much again. Halves would tell more closely, but agree by
    // chance too often: sampling that stops when they do errs by a third more than believed, where a code's numbers are
    // independent after all; with quarters it does not.
    double varianceOfMean(const Quarters& quarters)
    {
        const double mean = std::accumulate(quarters.begin(), quarters.end(), 0.0) / 4.0;
        double sum = 0.0;
        for (const double quarter : quarters)
            sum += (quarter - mean) * (quarter - mean);
        const double deviation = shownDeviation(mean, std::sqrt(sum / 3.0 / 4.0));
        return std::isfinite(deviation) ? deviation * deviation : 0.0; // of what is no number, more rays mend nothing
    }

}

Estimate estimateFrom(const std::array<glm::dvec3, 4>& quarters, uint32_t numRays)
{
    Estimate estimate { { 0.5 * (quarters[0] + quarters[1]), 0.5 * (quarters[2] + quarters[3]) }, 0.0, numRays };
    for (int channel = 0; channel < 3; ++channel)
        estimate.variance += varianceOfMean({ quarters[0][channel], quarters[1][channel], quarters[2][channel],
                                 quarters[3][channel] })
            / 3.0;
    return estimate;
}

Estimate doubled(const Estimate& estimate, const std::array<glm::dvec3, 2>& newHalves)
{
    return estimateFrom({ estimate.halves[0], estimate.halves[1], newHalves[0], newHalves[1] }, 2 * estimate.numRays);
}

}
