#pragma once
#include "grading/probes/recursion.h"
#include <glm/geometric.hpp>

namespace grading {

[[nodiscard]] inline glm::dvec3 straightOn(const Incidence& incidence)
{
    return glm::normalize(glm::dvec3(incidence.ray.direction));
}

[[nodiscard]] inline glm::dvec3 mirrored(const Incidence& incidence)
{
    const glm::dvec3 normal { incidence.hitInfo.normal };
    const glm::dvec3 direction = straightOn(incidence);
    return direction - 2.0 * glm::dot(direction, normal) * normal;
}

// A surface's colour and the light along the further ray -> what the two make together.
using Combine = glm::dvec3 (*)(const glm::dvec3& color, const Material&, const glm::dvec3& further);

[[nodiscard]] inline glm::dvec3 addMirrored(
    const glm::dvec3& color, const Material& material, const glm::dvec3& further)
{
    return color + glm::dvec3(material.ks) * further;
}

[[nodiscard]] inline glm::dvec3 blendWithBehind(
    const glm::dvec3& color, const Material& material, const glm::dvec3& further)
{
    const double alpha = material.transparency;
    return color * alpha + further * (1.0 - alpha);
}

// What a ray brings that meets this hit of the script, and by it the rest; fewer hits than the depth allows.
[[nodiscard]] inline glm::dvec3 lightFrom(const Recursion& recursion, Combine combine, std::size_t hit = 0)
{
    if (hit == recursion.hits.size())
        return glm::dvec3(0.0);
    const Material& material = recursion.hits[hit].material;
    const glm::dvec3 color = glm::dvec3(recursion.light) * glm::dvec3(material.kd);
    return combine(color, material, lightFrom(recursion, combine, hit + 1));
}

}
