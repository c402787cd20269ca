#include "interpolate.h"

// A candidate for the closest point of the triangle.
struct Candidate {
    glm::vec3 barycentric;
    float squaredDistance;
};

// Of the edge from corner `from` to corner `to`.
static Candidate closestOnEdge(const glm::vec3 (&corners)[3], int from, int to, const glm::vec3& p)
{
    const glm::vec3 edge = corners[to] - corners[from];
    const float squaredLength = glm::dot(edge, edge);
    const float s = squaredLength > 0.0f // an edge may be a point
        ? std::clamp(glm::dot(p - corners[from], edge) / squaredLength, 0.0f, 1.0f)
        : 0.0f;
    const glm::vec3 offset = p - (corners[from] + s * edge);
    Candidate candidate { glm::vec3(0.0f), glm::dot(offset, offset) };
    candidate.barycentric[from] = 1.0f - s;
    candidate.barycentric[to] = s;
    return candidate;
}

glm::vec3 computeBarycentricCoord(const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2, const glm::vec3& p)
{
    // The part of the triangle's area opposite each corner, with a sign: negative outside that edge.
    const glm::vec3 normal = glm::cross(v1 - v0, v2 - v0);
    const glm::vec3 area { glm::dot(normal, glm::cross(v2 - v1, p - v1)), glm::dot(normal, glm::cross(v0 - v2, p - v2)),
        glm::dot(normal, glm::cross(v1 - v0, p - v0)) };
    const float sum = area.x + area.y + area.z;
    // The areas of a needle, a thousand times longer than high, are lost in roundings, but its edges are close.
    const glm::vec3 edge0 = v2 - v1, edge1 = v0 - v2, edge2 = v1 - v0;
    const float longest
        = std::max({ glm::dot(edge0, edge0), glm::dot(edge1, edge1), glm::dot(edge2, edge2) }); // squared
    const float least = 0x1p-20f * longest * longest;
    if (area.x >= 0.0f && area.y >= 0.0f && area.z >= 0.0f && sum > least)
        return area / sum;

    // Outside, or a triangle without area: the closest point lies on an edge.
    const glm::vec3 corners[3] { v0, v1, v2 };
    Candidate closest = closestOnEdge(corners, 0, 1, p);
    for (const Candidate& candidate : { closestOnEdge(corners, 1, 2, p), closestOnEdge(corners, 2, 0, p) }) {
        if (candidate.squaredDistance < closest.squaredDistance)
            closest = candidate;
    }
    return closest.barycentric;
}

glm::vec3 interpolateNormal(const glm::vec3& n0, const glm::vec3& n1, const glm::vec3& n2, const glm::vec3 bc)
{
    const glm::vec3 sum = bc.x * n0 + bc.y * n1 + bc.z * n2;
    const float length = glm::length(sum);
    return length > 0.0f ? sum / length : n0; // opposite normals may cancel: any of them is better than NaN
}

glm::vec2 interpolateTexCoord(const glm::vec2& t0, const glm::vec2& t1, const glm::vec2& t2, const glm::vec3 bc)
{
    return bc.x * t0 + bc.y * t1 + bc.z * t2;
}
