#pragma once
#include "common.h"

// To implement: (alpha, beta, gamma), each in [0, 1] with sum 1, so that alpha * v0 + beta * v1 + gamma * v2 is the
// point of the triangle closest to p. Ericson 2005, "Real-Time Collision Detection", 5.1.5.
[[nodiscard]] glm::vec3 computeBarycentricCoord(
    const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2, const glm::vec3& p);

// To implement: the normals weighted by the barycentric coordinates, unit.
[[nodiscard]] glm::vec3 interpolateNormal(
    const glm::vec3& n0, const glm::vec3& n1, const glm::vec3& n2, const glm::vec3 bc);

// To implement: the texture coordinates weighted by the barycentric coordinates.
[[nodiscard]] glm::vec2 interpolateTexCoord(
    const glm::vec2& t0, const glm::vec2& t1, const glm::vec2& t2, const glm::vec3 bc);
