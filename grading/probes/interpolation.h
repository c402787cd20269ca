#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

// What the probes of the interpolating functions are asked.
namespace grading {

struct Triangle {
    glm::vec3 v0, v1, v2;
};

struct TrianglePoint {
    Triangle triangle;
    glm::vec3 p;
};

// A mean of three, weighted by barycentric coordinates.
template <typename V> struct Weighted {
    V a, b, c;
    glm::vec3 weights;
};

}
