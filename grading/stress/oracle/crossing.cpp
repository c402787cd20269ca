#include "grading/stress/oracle/crossing.h"

namespace stress {

Crossing::Crossing(const grading::Triangle& triangle, const Ray& ray, double allowed)
{
    const glm::dvec3 d { ray.direction };
    grading::Corners corners = grading::cornersOf(triangle);
    for (glm::dvec3& corner : corners)
        corner -= glm::dvec3(ray.origin);
    const auto& [a, b, c] = corners;
    const double speed = glm::length(d);

    int numPositive = 0, numNegative = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto &from = corners[i], &to = corners[(i + 1) % 3];
        const double volume = glm::dot(d, glm::cross(to, from));
        const double bound = allowed * rounding * speed * glm::length(from) * glm::length(to);
        numPositive += volume > bound;
        numNegative += volume < -bound;
    }
    const int numOneSide = std::max(numPositive, numNegative);
    const bool hasBothSides = numPositive > 0 && numNegative > 0;
    isSurelyInside = !hasBothSides && (allowed == 0.0 ? numOneSide > 0 : numOneSide == 3);
    isSurelyOutside = hasBothSides || (allowed == 0.0 && numOneSide == 0);

    normal = glm::cross(b - a, c - a);
    const double slope = glm::dot(normal, d);
    const double edges = glm::length(b - a) * glm::length(c - a);
    t = glm::dot(normal, a) / slope;
    slenderness = edges / glm::length(normal);
    const double farthest = std::max({ glm::length(a), glm::length(b), glm::length(c) });
    magnitude = std::abs(t) + (allowed == 0.0 ? 0.0 : edges * (farthest + std::abs(t) * speed) / std::abs(slope));
    const bool isLost = !(std::abs(slope) > 4.0 * allowed * rounding * edges * speed);
    error = isLost ? std::numeric_limits<double>::infinity() : std::max(allowed, 2.0) * rounding * magnitude;
}

bool isNormal(const glm::vec3& came, const Crossing& crossing, const Ray& ray)
{
    const double bound = (16.0 * crossing.slenderness + 4.0) * rounding;
    const glm::dvec3 normal { came }, exact = glm::normalize(crossing.normal);
    const double cosine = glm::dot(exact, glm::normalize(glm::dvec3(ray.direction)));
    const bool isUnit = std::abs(glm::length(normal) - 1.0) <= 8.0 * rounding;
    const bool isAlong = !(bound < 0.5) || glm::length(glm::cross(normal, exact)) <= bound;
    const bool faces = !(bound < std::abs(cosine)) || glm::dot(normal, exact) * cosine < 0.0;
    return isUnit && isAlong && faces;
}

}
