#pragma once
#include "common.h"

// What the reference and the provided models compute, for the compiler to put where it is used.
namespace worker {

// The sides of a triangle are met alike often: a jump would be foreseen in half of the cases.
[[nodiscard]] inline glm::vec3 turnedAgainst(const glm::vec3& direction, const glm::vec3& normal)
{
    return normal * (1.0f - 2.0f * static_cast<float>(glm::dot(normal, direction) > 0.0f));
}

[[nodiscard]] inline float largestCoordinate(const glm::vec3& v)
{
    return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}

// How far a ray keeps from a surface that was calculated from points of these sizes.
[[nodiscard]] inline float offsetBetween(const glm::vec3& from, const glm::vec3& to)
{
    return 0x1p-15f * std::max(largestCoordinate(from), largestCoordinate(to));
}

// The same of a surface that was calculated as their sum.
[[nodiscard]] inline float offsetOfSum(const glm::vec3& from, const glm::vec3& way)
{
    const glm::vec3 size = glm::max(from, -from) + glm::max(way, -way); // glm::abs would jump by signs
    return 0x1p-15f * largestCoordinate(size);
}

// What a surface of this opacity leaves of the light that goes through it.
[[nodiscard]] inline glm::vec3 lightBehind(
    const glm::vec3& light, const glm::vec3& kd, float alpha, const Features& features)
{
    const float t = 1.0f - alpha;
    if (!features.extra.enableProposedShadowFormula)
        return light * kd * t;
    return alpha == 1.0f ? glm::vec3(0.0f) : light * kd * (1.0f - t) + light * t;
}

[[nodiscard]] inline float phongLobe(
    const Material& material, const glm::vec3& normal, const glm::vec3& toLight, const glm::vec3& toCamera)
{
    const glm::vec3 mirrored = 2.0f * glm::dot(normal, toLight) * normal - toLight;
    return std::pow(std::clamp(glm::dot(mirrored, toCamera), 0.0f, 1.0f), material.shininess);
}

[[nodiscard]] inline float blinnLobe(
    const Material& material, const glm::vec3& normal, const glm::vec3& toLight, const glm::vec3& toCamera)
{
    const glm::vec3 sum = toLight + toCamera;
    const float length = glm::length(sum); // 0 where the camera looks from opposite the light
    const float cosine = length > 0.0f ? std::clamp(glm::dot(normal, sum) / length, 0.0f, 1.0f) : 0.0f;
    return std::pow(cosine, material.shininess);
}

}
