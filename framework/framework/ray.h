#pragma once
#include <cfloat>
#include <glm/vec3.hpp>

// A half-line with an end: the points origin + s * direction for s in [0, t].
struct Ray {
    glm::vec3 origin { 0.0f };
    glm::vec3 direction { 0.0f, 0.0f, -1.0f };
    float t = FLT_MAX; // in units of |direction|
};
