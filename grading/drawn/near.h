#pragma once
#include "common.h"

// What a look at a picture of the drawing takes for the same.
namespace grading {

// Solutions start a ray up to a hundredth above its surface.
[[nodiscard]] inline bool isNear(const glm::vec3& a, const glm::vec3& b)
{
    return glm::distance(a, b) <= 0.01f * std::max(1.0f, glm::length(b));
}

// About a degree; directions of any length.
[[nodiscard]] inline bool isAlong(const glm::vec3& direction, const glm::vec3& expected)
{
    return glm::distance(glm::normalize(direction), glm::normalize(expected)) <= 0.02f;
}

[[nodiscard]] inline glm::vec3 endOf(const Ray& ray)
{
    return ray.origin + ray.t * ray.direction;
}

}
