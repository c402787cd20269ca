#include "report/statistics.h"
#include <boost/math/distributions/chi_squared.hpp>
#include <glm/common.hpp>
#include <stdexcept>

namespace report {

std::vector<int> countCells(std::span<const glm::vec2> points, int cells)
{
    std::vector<int> counts(static_cast<std::size_t>(cells * cells));
    for (const glm::vec2& point : points) {
        const glm::ivec2 cell = glm::clamp(
            glm::ivec2(glm::floor(point * static_cast<float>(cells))), glm::ivec2(0), glm::ivec2(cells - 1));
        ++counts[static_cast<std::size_t>(cell.y * cells + cell.x)];
    }
    return counts;
}

double dispersion(std::span<const int> counts)
{
    double sum = 0.0, sumOfSquares = 0.0;
    for (const int count : counts) {
        sum += count;
        sumOfSquares += static_cast<double>(count) * count;
    }
    const auto number = static_cast<double>(counts.size());
    const double mean = sum / number;
    return (sumOfSquares / number - mean * mean) / mean;
}

double pValueOfDifference(std::span<const glm::vec2> a, std::span<const glm::vec2> b, int cells)
{
    if (a.size() != b.size())
        throw std::invalid_argument("expected as many points in both sets");
    const std::vector<int> inA = countCells(a, cells), inB = countCells(b, cells);
    double sum = 0.0;
    int numFilled = 0;
    for (std::size_t i = 0; i < inA.size(); ++i) {
        const double both = inA[i] + inB[i], gap = inA[i] - inB[i];
        if (both == 0.0)
            continue;
        sum += gap * gap / both;
        ++numFilled;
    }
    return numFilled < 2 ? 1.0
                         : boost::math::cdf(boost::math::complement(boost::math::chi_squared(numFilled - 1), sum));
}

}
