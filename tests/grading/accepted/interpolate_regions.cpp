#include "interpolate.h"

// The part of `whole` that `part` is; the start of an edge that is a point.
static float ratio(float part, float whole)
{
    return whole > 0.0f ? std::min(part / whole, 1.0f) : 0.0f;
}

glm::vec3 computeBarycentricCoord(const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2, const glm::vec3& p)
{
    const glm::vec3 ab = v1 - v0, ac = v2 - v0, bc = v2 - v1;
    const glm::vec3 n = glm::cross(ab, ac);

    // Along each edge, from either end.
    const float snom = glm::dot(p - v0, ab), sdenom = glm::dot(p - v1, -ab);
    const float tnom = glm::dot(p - v0, ac), tdenom = glm::dot(p - v2, -ac);
    const float unom = glm::dot(p - v1, bc), udenom = glm::dot(p - v2, -bc);
    const bool isFlat = glm::dot(n, n) == 0.0f;

    if (isFlat) { // the longest edge holds all of it
        const float l0 = glm::dot(ab, ab), l1 = glm::dot(ac, ac), l2 = glm::dot(bc, bc);
        if (l0 >= l1 && l0 >= l2) {
            const float s = std::max(ratio(snom, l0), 0.0f);
            return { 1.0f - s, s, 0.0f };
        }
        if (l1 >= l2) {
            const float t = std::max(ratio(tnom, l1), 0.0f);
            return { 1.0f - t, 0.0f, t };
        }
        const float u = std::max(ratio(unom, l2), 0.0f);
        return { 0.0f, 1.0f - u, u };
    }

    if (snom <= 0.0f && tnom <= 0.0f)
        return { 1, 0, 0 };
    if (sdenom <= 0.0f && unom <= 0.0f)
        return { 0, 1, 0 };
    if (tdenom <= 0.0f && udenom <= 0.0f)
        return { 0, 0, 1 };

    const float vc = glm::dot(n, glm::cross(v0 - p, v1 - p));
    if (vc <= 0.0f && snom >= 0.0f && sdenom >= 0.0f) {
        const float s = ratio(snom, snom + sdenom);
        return { 1.0f - s, s, 0.0f };
    }
    const float va = glm::dot(n, glm::cross(v1 - p, v2 - p));
    if (va <= 0.0f && unom >= 0.0f && udenom >= 0.0f) {
        const float u = ratio(unom, unom + udenom);
        return { 0.0f, 1.0f - u, u };
    }
    const float vb = glm::dot(n, glm::cross(v2 - p, v0 - p));
    if (vb <= 0.0f && tnom >= 0.0f && tdenom >= 0.0f) {
        const float t = ratio(tnom, tnom + tdenom);
        return { 1.0f - t, 0.0f, t };
    }
    return glm::vec3(va, vb, vc) / (va + vb + vc);
}

glm::vec3 interpolateNormal(const glm::vec3& n0, const glm::vec3& n1, const glm::vec3& n2, const glm::vec3 bc)
{
    return glm::normalize(n0 * bc.x + n1 * bc.y + n2 * bc.z);
}

glm::vec2 interpolateTexCoord(const glm::vec2& t0, const glm::vec2& t1, const glm::vec2& t2, const glm::vec3 bc)
{
    return { t0.x * bc.x + t1.x * bc.y + t2.x * bc.z, t0.y * bc.x + t1.y * bc.y + t2.y * bc.z };
}
