#pragma once
#include "common.h"
#include "fwd.h"
#include "render.h"

// In all functions ray.origin + ray.t * ray.direction is the shaded point and hitInfo its surface.

// To implement: the point of the light at a fraction sample in [0, 1) from endpoint0, and its colour.
void sampleSegmentLight(const float& sample, const SegmentLight& light, glm::vec3& position, glm::vec3& color);

// To implement: the point v0 + sample.x * edge01 + sample.y * edge02, sample in [0, 1)^2, and its colour.
void sampleParallelogramLight(
    const glm::vec2& sample, const ParallelogramLight& light, glm::vec3& position, glm::vec3& color);

// To implement: whether nothing lies between the shaded point and the light.
[[nodiscard]] bool visibilityOfLightSampleBinary(RenderState& state, const glm::vec3& lightPosition,
    const glm::vec3& lightColor, const Ray& ray, const HitInfo& hitInfo);

// To implement: the light that is left of lightColor when each surface in between multiplies it by kd * (1 - alpha).
[[nodiscard]] glm::vec3 visibilityOfLightSampleTransparency(RenderState& state, const glm::vec3& lightPosition,
    const glm::vec3& lightColor, const Ray& ray, const HitInfo& hitInfo);

// Provided: whether the light may leave anything at all on the surface by the provided models of shading, if it gets
// there. False, only where needs.lightFromBehind is, for a light below the surface, and where either is black.
// lightDirection: as in computeShading.
[[nodiscard]] inline bool canBeLit(
    const RenderState& state, const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo);

// Provided: lightColor with shadows off; one of the two above with shadows on.
[[nodiscard]] glm::vec3 visibilityOfLightSample(RenderState& state, const glm::vec3& lightPosition,
    const glm::vec3& lightColor, const Ray& ray, const HitInfo& hitInfo);

// To implement: the shading of what is visible of the light; an area light's is the mean over numSamples samples.
[[nodiscard]] glm::vec3 computeContributionPointLight(
    RenderState& state, const PointLight& light, const Ray& ray, const HitInfo& hitInfo);
[[nodiscard]] glm::vec3 computeContributionSegmentLight(
    RenderState& state, const SegmentLight& light, const Ray& ray, const HitInfo& hitInfo, uint32_t numSamples);
[[nodiscard]] glm::vec3 computeContributionParallelogramLight(
    RenderState& state, const ParallelogramLight& light, const Ray& ray, const HitInfo& hitInfo, uint32_t numSamples);

// Provided: the sum over all lights of the scene.
[[nodiscard]] glm::vec3 computeLightContribution(RenderState& state, const Ray& ray, const HitInfo& hitInfo);

namespace lighting {

[[nodiscard]] inline bool isBlack(const glm::vec3& color)
{
    return color.x == 0.0f && color.y == 0.0f && color.z == 0.0f; // most often the first says it
}

[[nodiscard]] inline bool isDull(const Material& material)
{
    return isBlack(material.kd) && isBlack(material.ks) && !material.kdTexture;
}

void countUnlit(); // a sample of a light that was left out

}

// Here, so that nothing is called: it is asked for every sample of a light.
inline bool canBeLit(
    const RenderState& state, const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo)
{
    if (state.needs.lightFromBehind)
        return true;
    const bool isBelow = glm::dot(hitInfo.normal, lightDirection) <= 0.0f; // not if that is NaN, which is to be seen
    if (!isBelow && !lighting::isBlack(lightColor) && !lighting::isDull(hitInfo.material))
        return true;
    lighting::countUnlit();
    return false;
}
