#include "interpolate.h"
#include <glm/geometric.hpp>

glm::vec3 solve(const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2, const glm::vec3& p)
{
    glm::vec3 n = glm::cross(v1 - v0, v2 - v0);
    float area = glm::dot(n, n);
    float beta = glm::dot(glm::cross(p - v0, v2 - v0), n) / area;
    float gamma = glm::dot(glm::cross(v1 - v0, p - v0), n) / area;
    return { 1.f - beta - gamma, beta, gamma };
}

glm::vec3 computeBarycentricCoord(const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2, const glm::vec3& p)
{
    glm::vec3 bc = solve(v0, v1, v2, p);
    if (bc.x >= 0.f && bc.y >= 0.f && bc.z >= 0.f)
        return bc;
    float best = FLT_MAX;
    const glm::vec3 v[3] = { v0, v1, v2 };
    for (int i = 0; i < 3; i++) {
        glm::vec3 a = v[i], b = v[(i + 1) % 3];
        float l = glm::dot(b - a, b - a);
        float s = l == 0.f ? 0.f : glm::clamp(glm::dot(p - a, b - a) / l, 0.f, 1.f);
        float distance = glm::length(p - glm::mix(a, b, s));
        if (distance < best) {
            best = distance;
            bc = glm::vec3(0.f);
            bc[i] = 1.f - s;
            bc[(i + 1) % 3] = s;
        }
    }
    return bc;
}

glm::vec3 interpolateNormal(const glm::vec3& n0, const glm::vec3& n1, const glm::vec3& n2, const glm::vec3 bc)
{
    return glm::normalize(n0 * bc.x + n1 * bc.y + n2 * bc.z);
}

glm::vec2 interpolateTexCoord(const glm::vec2& t0, const glm::vec2& t1, const glm::vec2& t2, const glm::vec3 bc)
{
    return bc.x * t0 + bc.y * t1 + bc.z * t2;
}
