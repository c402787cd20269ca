#pragma once
#include "grading/oracle/triangle.h"
#include <framework/ray.h>

namespace stress {

// Half a unit in the last place of 1: the largest relative error of a rounding to single precision.
inline constexpr double rounding = 0x1p-24;

// How the line of a ray passes a triangle, in double precision, and what of that an intersection in single precision
// may see differently. Sides of edges are volumes as seen from the ray's origin, a distance is a quotient of two:
// products of three lengths with eight roundings, of three differences, a cross and a dot product (Higham 2002,
// "Accuracy and Stability of Numerical Algorithms", section 3.1). Twice as many are allowed, for other ways to
// calculate. What double precision errs itself is 2^-29 of that.
class Crossing {
public:
    // allowed: how many roundings; 0 where single precision calculates without any.
    Crossing(const grading::Triangle& triangle, const Ray& ray, double allowed = 16.0);

    // Inside the triangle or on its edge, or not; both false where roundings decide.
    bool isSurelyInside, isSurelyOutside;
    double t; // in units of |direction|; not finite where the ray and the plane are parallel
    double error; // that a distance may have; infinity where the plane is lost in roundings
    double magnitude; // of what t is calculated from, as far as that counts: roundings are relative to it
    glm::dvec3 normal; // on the side of counter-clockwise v0, v1, v2; not unit
    double slenderness; // of the triangle: the product of two edges over the area between them

    [[nodiscard]] double ulpsOf(double distance) const { return std::abs(distance - t) / (2.0 * rounding * magnitude); }

    // Whether the ray meets the triangle at a distance in [0, end], or not; both false where roundings decide.
    [[nodiscard]] bool isSurelyMet(double end) const { return isSurelyInside && t - error >= 0.0 && t + error <= end; }
    [[nodiscard]] bool isSurelyMissed(double end) const
    {
        return isSurelyOutside || t + error < 0.0 || t - error > end;
    }
    // Whether that is a distance at which it may be met.
    [[nodiscard]] bool mayBeMetAt(double distance) const
    {
        return !isSurelyOutside && !(std::abs(distance - t) > error);
    }
};

// Whether that is the unit normal towards where the ray came from, off by no more than a cross product of rounded
// edges.
[[nodiscard]] bool isNormal(const glm::vec3& came, const Crossing& crossing, const Ray& ray);

}
