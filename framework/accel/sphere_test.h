#pragma once
#include "common.h"
#include <cmath>
#include <framework/ray.h>

namespace accel {

// The first root of |origin + t * direction - center| = radius that is not negative; negative or not a number if there
// is none. The point of the line closest to the centre is found first, so that a small or far sphere loses no digits to
// the square of its distance. Haines, Guenther, Akenine-Moller 2019, "Precision Improvements for Ray/Sphere
// Intersection", Ray Tracing Gems 7.
[[nodiscard]] inline float firstDistance(const Sphere& sphere, const Ray& ray)
{
    const glm::vec3 f = ray.origin - sphere.center;
    const float a = glm::dot(ray.direction, ray.direction);
    const float b = -glm::dot(f, ray.direction);
    const glm::vec3 closest = f + (b / a) * ray.direction;
    const float discriminant = sphere.radius * sphere.radius - glm::dot(closest, closest);
    if (!(discriminant >= 0.0f))
        return -1.0f;
    const float c = glm::dot(f, f) - sphere.radius * sphere.radius;
    const float q = b + std::copysign(std::sqrt(a * discriminant), b);
    const float t0 = q == 0.0f ? 0.0f : c / q; // q cancels nothing; the other root follows from the product
    const float t1 = q / a;
    const float near = std::min(t0, t1);
    return near >= 0.0f ? near : std::max(t0, t1);
}

// Whether the ray meets the sphere at a distance in [0, ray.t].
[[nodiscard]] inline bool meets(const Sphere& sphere, const Ray& ray)
{
    const float t = firstDistance(sphere, ray);
    return t >= 0.0f && t <= ray.t;
}

}
