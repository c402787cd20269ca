#pragma once
#include "truth/polygon.h"
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <glm/vec3.hpp>

namespace truth {

using Rule = boost::math::quadrature::gauss<double, 15>; // exact for polynomials up to degree 29

// The integral of f: double -> dvec3 over [from, to], by halves until they agree to the tolerance.
template <typename F> [[nodiscard]] glm::dvec3 integrate(const F& f, double from, double to, double tolerance)
{
    const auto whole = [&](double a, double b) {
        glm::dvec3 sum(0.0);
        const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
        for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
            const double x = Rule::abscissa()[i] * half, weight = Rule::weights()[i] * half;
            sum += weight * (x == 0.0 ? f(middle) : f(middle - x) + f(middle + x));
        }
        return sum;
    };
    const double middle = 0.5 * (from + to);
    const glm::dvec3 halves = whole(from, middle) + whole(middle, to);
    const glm::dvec3 difference = halves - whole(from, to);
    const double error = std::max({ std::abs(difference.x), std::abs(difference.y), std::abs(difference.z) });
    if (error <= tolerance || !(from < middle && middle < to))
        return halves;
    return integrate(f, from, middle, 0.5 * tolerance) + integrate(f, middle, to, 0.5 * tolerance);
}

// Of f: dvec2 -> dvec3 over the polygon.
template <typename F> [[nodiscard]] glm::dvec3 integrate(const F& f, const Polygon& polygon, double tolerance)
{
    glm::dvec3 sum(0.0);
    for (std::size_t i = 2; i < polygon.size(); ++i) { // a triangle: lines from its first corner to points across
        const glm::dvec2 corner = polygon[0], a = polygon[i - 1] - corner, b = polygon[i] - corner;
        const double doubledArea = std::abs(a.x * b.y - a.y * b.x);
        const auto acrossLine = [&](double s) {
            const glm::dvec2 end = (1.0 - s) * a + s * b;
            return integrate([&](double r) { return r * f(corner + r * end); }, 0.0, 1.0, tolerance);
        };
        sum += doubledArea * integrate(acrossLine, 0.0, 1.0, tolerance);
    }
    return sum;
}

}
