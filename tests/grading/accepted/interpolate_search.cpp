#include "interpolate.h"

static float squaredDistance(const glm::vec3& a, const glm::vec3& b)
{
    return glm::dot(a - b, a - b);
}

// The weights of the closest point of an edge.
static glm::vec3 closestOnEdge(const glm::mat3& corners, int from, int to, const glm::vec3& p)
{
    const glm::vec3 edge = corners[to] - corners[from];
    glm::vec3 weights(0.0f);
    weights[to] = glm::clamp(glm::dot(p - corners[from], edge) / std::max(glm::dot(edge, edge), 1e-30f), 0.0f, 1.0f);
    weights[from] = 1.0f - weights[to];
    return weights;
}

glm::vec3 computeBarycentricCoord(const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2, const glm::vec3& p)
{
    const glm::mat3 corners(v0, v1, v2);
    std::vector<glm::vec3> candidates {
        closestOnEdge(corners, 0, 1, p),
        closestOnEdge(corners, 0, 2, p),
        closestOnEdge(corners, 1, 2, p),
    };

    // p - v0 in the basis of two edges and the normal.
    const glm::vec3 n = glm::cross(v1 - v0, v2 - v0);
    if (n != glm::vec3(0.0f)) {
        const glm::vec3 local = glm::inverse(glm::mat3(v1 - v0, v2 - v0, glm::normalize(n))) * (p - v0);
        if (local.x > 0.0f && local.y > 0.0f && local.x + local.y < 1.0f)
            return { 1.0f - local.x - local.y, local.x, local.y };
    }
    return *std::min_element(candidates.begin(), candidates.end(), [&](const glm::vec3& a, const glm::vec3& b) {
        return squaredDistance(corners * a, p) < squaredDistance(corners * b, p);
    });
}

glm::vec3 interpolateNormal(const glm::vec3& n0, const glm::vec3& n1, const glm::vec3& n2, const glm::vec3 bc)
{
    glm::vec3 normal(0.0f);
    normal += bc.z * n2;
    normal += bc.y * n1;
    normal += bc.x * n0;
    return glm::normalize(normal);
}

glm::vec2 interpolateTexCoord(const glm::vec2& t0, const glm::vec2& t1, const glm::vec2& t2, const glm::vec3 bc)
{
    const glm::vec3 u(t0.x, t1.x, t2.x);
    const glm::vec3 v(t0.y, t1.y, t2.y);
    return { glm::dot(bc, u), glm::dot(bc, v) };
}
