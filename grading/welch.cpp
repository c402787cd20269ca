#include "grading/welch.h"
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace grading {

Sample summarize(std::span<const double> values)
{
    const auto n = static_cast<double>(values.size());
    double sum = 0.0, sumOfSquares = 0.0, sumOfDeviations = 0.0;
    for (const double value : values) {
        sum += value;
        sumOfSquares += value * value;
    }
    const double mean = sum / n;
    for (const double value : values)
        sumOfDeviations += (value - mean) * (value - mean);
    return { static_cast<int>(values.size()), mean, sumOfDeviations / (n - 1.0),
        sumOfSquares > 0.0 ? sum * sum / sumOfSquares : n };
}

Difference differenceOf(const Sample& a, const Sample& b)
{
    const double ofA = a.variance / a.size, ofB = b.variance / b.size; // variances of the means
    const double both = ofA + ofB;
    const double spread = ofA * ofA / (a.size - 1) + ofB * ofB / (b.size - 1);
    const double degrees = spread > 0.0 ? both * both / spread : a.size + b.size - 2.0;
    return { a.mean - b.mean, std::sqrt(both), degrees };
}

double chanceOf(const Difference& difference, double allowed)
{
    const double excess = std::abs(difference.value) - allowed;
    if (!(excess > 0.0))
        return 1.0;
    const double t = excess / difference.deviation;
    if (!std::isfinite(t))
        return 0.0;
    const boost::math::students_t distribution { difference.degrees };
    return 2.0 * boost::math::cdf(boost::math::complement(distribution, t)); // to either side
}

}
