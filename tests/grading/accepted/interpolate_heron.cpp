#include "interpolate.h"

static double heron(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const double x = glm::distance(a, b), y = glm::distance(b, c), z = glm::distance(c, a);
    const double s = (x + y + z) / 2.0;
    return std::sqrt(std::max(s * (s - x) * (s - y) * (s - z), 0.0));
}

static glm::dvec3 closestOnSegment(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p)
{
    const double squared = glm::dot(b - a, b - a);
    const double s = squared > 0.0 ? glm::clamp(glm::dot(p - a, b - a) / squared, 0.0, 1.0) : 0.0;
    return a + s * (b - a);
}

// Of a point on the segment.
static double partOfSegment(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p)
{
    const double length = glm::distance(a, b);
    return length > 0.0 ? std::min(glm::distance(a, p) / length, 1.0) : 0.0;
}

glm::vec3 computeBarycentricCoord(const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2, const glm::vec3& p)
{
    const glm::dvec3 a(v0), b(v1), c(v2), q(p);
    const double whole = heron(a, b, c);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    if (glm::length(normal) > 0.0) {
        const glm::dvec3 n = glm::normalize(normal);
        const glm::dvec3 foot = q - glm::dot(q - a, n) * n;
        const bool isInside = glm::dot(glm::cross(b - a, foot - a), n) > 0.0
            && glm::dot(glm::cross(c - b, foot - b), n) > 0.0 && glm::dot(glm::cross(a - c, foot - c), n) > 0.0;
        if (isInside)
            return glm::vec3(heron(foot, b, c) / whole, heron(a, foot, c) / whole, heron(a, b, foot) / whole);
    }

    const glm::dvec3 onAB = closestOnSegment(a, b, q);
    const glm::dvec3 onBC = closestOnSegment(b, c, q);
    const glm::dvec3 onCA = closestOnSegment(c, a, q);
    const double nearest = std::min({ glm::distance(onAB, q), glm::distance(onBC, q), glm::distance(onCA, q) });
    if (glm::distance(onAB, q) == nearest) {
        const double s = partOfSegment(a, b, onAB);
        return glm::vec3(1.0 - s, s, 0.0);
    }
    if (glm::distance(onBC, q) == nearest) {
        const double s = partOfSegment(b, c, onBC);
        return glm::vec3(0.0, 1.0 - s, s);
    }
    const double s = partOfSegment(c, a, onCA);
    return glm::vec3(s, 0.0, 1.0 - s);
}

glm::vec3 interpolateNormal(const glm::vec3& n0, const glm::vec3& n1, const glm::vec3& n2, const glm::vec3 bc)
{
    const glm::dvec3 b(bc);
    return glm::vec3(glm::normalize(b.x * glm::dvec3(n0) + b.y * glm::dvec3(n1) + b.z * glm::dvec3(n2)));
}

glm::vec2 interpolateTexCoord(const glm::vec2& t0, const glm::vec2& t1, const glm::vec2& t2, const glm::vec3 bc)
{
    const glm::dvec3 b(bc);
    return glm::vec2(b.x * glm::dvec2(t0) + b.y * glm::dvec2(t1) + b.z * glm::dvec2(t2));
}
