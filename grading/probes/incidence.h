#pragma once
#include "common.h"

namespace grading {

// A ray and the surface that it met at ray.origin + ray.t * ray.direction.
struct Incidence {
    Ray ray;
    HitInfo hitInfo; // without a texture

    [[nodiscard]] glm::dvec3 point() const
    {
        return glm::dvec3(ray.origin) + static_cast<double>(ray.t) * glm::dvec3(ray.direction);
    }
};

}
