#include "adaptive/believed_errors.h"
#include <algorithm>
#include <cmath>

namespace adaptive {
namespace {

    // What a pixel with so many rays would have: the law that gives more, of even samples on edges (Mitchell 1996,
    // "Consequences of Stratified Sampling in Graphics") where it had fewer, of independent ones where it had more.
    double varianceWith(uint32_t numRays, const Estimate& estimate)
    {
        const double ratio = static_cast<double>(estimate.numRays) / numRays;
        return estimate.variance * (ratio > 1.0 ? ratio * std::sqrt(ratio) : ratio);
    }

    // The weighted mean of what the pixel and its neighbours know, 4 : 2 : 1 by how near they are.
    double smoothedVariance(std::span<const Estimate> estimates, glm::ivec2 size, glm::ivec2 pixel)
    {
        const auto at = [&](int x, int y) -> const Estimate& {
            return estimates[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x)
                + static_cast<std::size_t>(x)];
        };
        const uint32_t numRays = at(pixel.x, pixel.y).numRays;
        double sum = 0.0, weights = 0.0;
        for (int y = std::max(pixel.y - 1, 0); y <= std::min(pixel.y + 1, size.y - 1); ++y) {
            for (int x = std::max(pixel.x - 1, 0); x <= std::min(pixel.x + 1, size.x - 1); ++x) {
                const double weight = (x == pixel.x ? 2.0 : 1.0) * (y == pixel.y ? 2.0 : 1.0);
                sum += weight * varianceWith(numRays, at(x, y));
                weights += weight;
            }
        }
        return sum / weights;
    }

}

std::vector<double> believedErrors(std::span<const Estimate> estimates, glm::ivec2 size)
{
    std::vector<double> errors;
    errors.reserve(estimates.size());
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            errors.push_back(std::sqrt(smoothedVariance(estimates, size, { x, y })));
    return errors;
}

}
