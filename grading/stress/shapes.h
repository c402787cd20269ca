#pragma once
#include "grading/probes/interpolation.h"
#include "grading/stress/random.h"
#include <framework/ray.h>

namespace stress {

// Three unit vectors at right angles.
struct Frame {
    glm::vec3 along, across, up;
};

[[nodiscard]] Frame randomFrame(Random& random);

// How a random triangle lies, and how a ray comes to it.
struct Setting {
    float size = 1.0f; // of the longest edge
    float slenderness = 1.0f; // longer than high
    float farFromZero = 1.0f; // sizes between it and the origin of space, at most
    float distance = 3.0f; // sizes between it and the ray's origin
    float sine = 0.5f; // of the angle between the ray and the plane
};

// A triangle in the frame, its first corner's edge to the second along it.
[[nodiscard]] grading::Triangle triangleIn(const Frame& frame, Random& random, const Setting& setting);

// Weights of the sum 1: of a point inside, or about the triangle.
[[nodiscard]] glm::vec3 weightsInside(Random& random);
[[nodiscard]] glm::vec3 weightsAround(Random& random);

[[nodiscard]] inline glm::vec3 pointOf(const grading::Triangle& triangle, const glm::vec3& weights)
{
    return weights.x * triangle.v0 + weights.y * triangle.v1 + weights.z * triangle.v2;
}

// From either side towards the point; the direction of any length from 1e-3 to 1e3, without an end.
[[nodiscard]] Ray rayTo(const glm::vec3& point, const Frame& frame, Random& random, const Setting& setting);

}
