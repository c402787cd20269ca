#include "interpolate.h"

static float alongEdge(const glm::vec3& start, const glm::vec3& end, const glm::vec3& p)
{
    const glm::vec3 edge = end - start;
    const float squared = glm::dot(edge, edge);
    if (squared == 0.0f)
        return 0.0f;
    return glm::clamp(glm::dot(p - start, edge) / squared, 0.0f, 1.0f);
}

glm::vec3 computeBarycentricCoord(const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2, const glm::vec3& p)
{
    const glm::vec3 e0 = v1 - v0;
    const glm::vec3 e1 = v2 - v0;
    const glm::vec3 e2 = p - v0;
    const float d00 = glm::dot(e0, e0);
    const float d01 = glm::dot(e0, e1);
    const float d11 = glm::dot(e1, e1);
    const float d20 = glm::dot(e2, e0);
    const float d21 = glm::dot(e2, e1);
    const float denom = d00 * d11 - d01 * d01;

    const float beta = (d11 * d20 - d01 * d21) / denom;
    const float gamma = (d00 * d21 - d01 * d20) / denom;
    const float alpha = 1.0f - beta - gamma;
    if (denom > 0.0f && alpha >= 0.0f && beta >= 0.0f && gamma >= 0.0f)
        return glm::vec3(alpha, beta, gamma);

    const float s01 = alongEdge(v0, v1, p);
    const float s12 = alongEdge(v1, v2, p);
    const float s20 = alongEdge(v2, v0, p);
    const float d01p = glm::distance(p, glm::mix(v0, v1, s01));
    const float d12p = glm::distance(p, glm::mix(v1, v2, s12));
    const float d20p = glm::distance(p, glm::mix(v2, v0, s20));
    if (d01p <= d12p && d01p <= d20p)
        return glm::vec3(1.0f - s01, s01, 0.0f);
    if (d12p <= d20p)
        return glm::vec3(0.0f, 1.0f - s12, s12);
    return glm::vec3(s20, 0.0f, 1.0f - s20);
}

glm::vec3 interpolateNormal(const glm::vec3& n0, const glm::vec3& n1, const glm::vec3& n2, const glm::vec3 bc)
{
    const glm::vec3 n = bc[0] * n0 + bc[1] * n1 + bc[2] * n2;
    return n / std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
}

glm::vec2 interpolateTexCoord(const glm::vec2& t0, const glm::vec2& t1, const glm::vec2& t2, const glm::vec3 bc)
{
    return bc[0] * t0 + bc[1] * t1 + bc[2] * t2;
}
