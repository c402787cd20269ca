#include "intersect.h"

Plane trianglePlane(const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2)
{
    const glm::vec3 normal = glm::normalize(glm::cross(v1 - v0, v2 - v0));
    return { .D = glm::dot(v0, normal), .normal = normal };
}
