#pragma once
#include "common.h"

// What the probes of lights are asked about.
namespace grading {

// The surface at ray.origin + ray.t * ray.direction.
struct ShadedPoint {
    Ray ray;
    HitInfo hitInfo; // without a texture

    [[nodiscard]] glm::dvec3 point() const
    {
        return glm::dvec3(ray.origin) + static_cast<double>(ray.t) * glm::dvec3(ray.direction);
    }
};

struct LightSample {
    glm::vec3 position, color;
};

}
