#include "grading/stress/oracle/exact.h"
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

namespace stress {
namespace {

    using Number = boost::multiprecision::cpp_rational;
    using Vector = std::array<Number, 3>;

    Vector exact(const glm::vec3& v)
    {
        return { Number(v.x), Number(v.y), Number(v.z) };
    }

    Vector operator-(const Vector& a, const Vector& b)
    {
        return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
    }

    Number dot(const Vector& a, const Vector& b)
    {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    Vector cross(const Vector& a, const Vector& b)
    {
        return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
    }

}

std::optional<double> exactDistance(const grading::Triangle& triangle, const Ray& ray)
{
    const Vector origin = exact(ray.origin), direction = exact(ray.direction);
    const Vector a = exact(triangle.v0), b = exact(triangle.v1), c = exact(triangle.v2);
    const Vector normal = cross(b - a, c - a);
    const Number slope = dot(normal, direction);
    if (slope == 0)
        return std::nullopt;
    const Number t = dot(normal, a - origin) / slope;
    Vector point;
    for (std::size_t i = 0; i < 3; ++i)
        point[i] = origin[i] + t * direction[i];
    const std::array<Vector, 3> corners { a, b, c };
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector& from = corners[i];
        if (dot(normal, cross(corners[(i + 1) % 3] - from, point - from)) < 0)
            return std::nullopt;
    }
    if (t < 0 || (std::isfinite(ray.t) && t > Number(ray.t)))
        return std::nullopt;
    return static_cast<double>(t);
}

}
