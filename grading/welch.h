#pragma once
#include <cmath>
#include <span>

namespace grading {

// What a sample of independent values tells about their mean.
struct Sample {
    int size = 0;
    double mean = 0.0;
    double variance = 0.0; // of one value
    // (sum x)^2 / sum x^2, Kish 1965: as many values of about the same size would tell as much. A few large ones among
    // many near zero make it small, and then neither mean nor variance can be trusted.
    double effectiveSize = 0.0;
};

[[nodiscard]] inline double deviationOfMean(const Sample& sample)
{
    return std::sqrt(sample.variance / sample.size);
}

// Two values or more.
[[nodiscard]] Sample summarize(std::span<const double> values);

// The difference of two samples' means and what chance makes of it: Welch 1947, "The Generalization of 'Student's'
// Problem when Several Different Population Variances are Involved".
struct Difference {
    double value = 0.0; // of the means
    double deviation = 0.0; // its standard deviation; 0 if neither sample varies
    double degrees = 0.0; // of freedom, by Welch and Satterthwaite
};

[[nodiscard]] Difference differenceOf(const Sample& a, const Sample& b);

// The probability that chance alone makes a difference this large where the true one is `allowed` or less. One or 0
// where nothing varies.
[[nodiscard]] double chanceOf(const Difference& difference, double allowed);

}
