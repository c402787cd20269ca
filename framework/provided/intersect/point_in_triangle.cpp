#include "intersect.h"

bool pointInTriangle(
    const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2, const glm::vec3& n, const glm::vec3& p)
{
    const float side0 = glm::dot(glm::cross(v1 - v0, p - v0), n);
    const float side1 = glm::dot(glm::cross(v2 - v1, p - v1), n);
    const float side2 = glm::dot(glm::cross(v0 - v2, p - v2), n);
    return (side0 >= 0.0f && side1 >= 0.0f && side2 >= 0.0f) || (side0 <= 0.0f && side1 <= 0.0f && side2 <= 0.0f);
}
