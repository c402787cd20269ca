#include "light.h"
#include "bvh_interface.h"
#include "draw.h"
#include "shading.h"

void sampleSegmentLight(const float& sample, const SegmentLight& light, glm::vec3& position, glm::vec3& color)
{
    position = glm::mix(light.endpoint0, light.endpoint1, sample);
    color = glm::mix(light.color0, light.color1, sample);
}

void sampleParallelogramLight(
    const glm::vec2& sample, const ParallelogramLight& light, glm::vec3& position, glm::vec3& color)
{
    position = light.v0 + sample.x * light.edge01 + sample.y * light.edge02;
    const glm::vec3 nearV0 = glm::mix(light.color0, light.color1, sample.x);
    const glm::vec3 opposite = glm::mix(light.color2, light.color3, sample.x);
    color = glm::mix(nearV0, opposite, sample.y);
}

static glm::vec3 hitPoint(const Ray& ray)
{
    return ray.origin + ray.t * ray.direction;
}

static float largestCoordinate(const glm::vec3& v)
{
    return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}

// How far a shadow ray keeps from the surfaces at both of its ends: well above the error of a point that is calculated
// from these two, well below what can be seen. Roundings are relative to the numbers, whatever the scene's scale: pbrt,
// "Managing Rounding Error".
static inline float shadowOffset(const glm::vec3& from, const glm::vec3& to)
{
    // 512 roundings; there are about a dozen
    return 0x1p-15f * std::max(largestCoordinate(from), largestCoordinate(to));
}

// From just above the shaded point to just before the light, direction unit.
static inline Ray shadowRay(const glm::vec3& lightPosition, const Ray& ray, const HitInfo& hitInfo)
{
    const glm::vec3 point = hitPoint(ray);
    const float offset = shadowOffset(ray.origin, point);
    const glm::vec3 origin = point + offset * hitInfo.normal;
    const glm::vec3 toLight = lightPosition - origin;
    const float distance = glm::length(toLight);
    return { .origin = origin, .direction = toLight / distance, .t = distance - shadowOffset(origin, lightPosition) };
}

bool visibilityOfLightSampleBinary(
    RenderState& state, const glm::vec3& lightPosition, const glm::vec3&, const Ray& ray, const HitInfo& hitInfo)
{
    if (!state.features.enableShadows)
        return true;
    const Ray toLight = shadowRay(lightPosition, ray, hitInfo);
    return !state.bvh.isOccluded(state, toLight);
}

// What a surface leaves of the light that goes through it. alpha is the surface's opacity.
static glm::vec3 lightBehind(const glm::vec3& light, const glm::vec3& kd, float alpha)
{
    return light * kd * (1.0f - alpha);
}

// The correction proposed for it, with t = 1 - alpha: a clear surface no longer darkens or colours the light, and
// a nearly opaque one still leaves light * kd, which is too much.
static glm::vec3 lightBehindProposed(const glm::vec3& light, const glm::vec3& kd, float alpha)
{
    const float t = 1.0f - alpha;
    return alpha == 1.0f ? glm::vec3(0.0f) : light * kd * (1.0f - t) + light * t;
}

glm::vec3 visibilityOfLightSampleTransparency(RenderState& state, const glm::vec3& lightPosition,
    const glm::vec3& lightColor, const Ray& ray, const HitInfo& hitInfo)
{
    if (!state.features.enableShadows)
        return lightColor;
    Ray remaining = shadowRay(lightPosition, ray, hitInfo);
    if (!state.needs.shadowsInOrder) // whatever lies between is opaque
        return remaining.t > 0.0f && state.bvh.isOccluded(state, remaining) ? glm::vec3(0.0f) : lightColor;
    const auto formula = state.features.extra.enableProposedShadowFormula ? lightBehindProposed : lightBehind;
    glm::vec3 light = lightColor;
    while (remaining.t > 0.0f && light != glm::vec3(0.0f)) {
        Ray toSurface = remaining;
        HitInfo surface;
        if (!state.bvh.intersect(state, toSurface, surface))
            break;
        light = formula(light, sampleMaterialKd(state, surface), surface.material.transparency);
        const glm::vec3 point = hitPoint(toSurface);
        const float offset = shadowOffset(remaining.origin, point);
        remaining.origin = point + offset * remaining.direction;
        remaining.t -= toSurface.t + offset;
    }
    return light;
}

static glm::vec3 towardsCamera(const Ray& ray)
{
    return -glm::normalize(ray.direction);
}

// The shading of what arrives from one point of a light.
static glm::vec3 contributionOfSample(RenderState& state, const glm::vec3& lightPosition, const glm::vec3& lightColor,
    const glm::vec3& cameraDirection, const Ray& ray, const HitInfo& hitInfo)
{
    const glm::vec3 point = hitPoint(ray);
    const glm::vec3 toLight = lightPosition - point;
    const float distance = glm::length(toLight);
    if (distance == 0.0f) // the light is in the surface, and shines along it
        return glm::vec3(0.0f);
    const glm::vec3 lightDirection = toLight / distance;
    drawRay({ point, lightDirection, distance }, glm::vec3(1.0f, 0.0f, 0.0f));
    if (!canBeLit(state, lightDirection, lightColor, hitInfo))
        return glm::vec3(0.0f);

    const glm::vec3 visible = visibilityOfLightSample(state, lightPosition, lightColor, ray, hitInfo);
    if (visible == glm::vec3(0.0f))
        return visible;
    return computeShading(state, cameraDirection, lightDirection, visible, hitInfo);
}

glm::vec3 computeContributionPointLight(
    RenderState& state, const PointLight& light, const Ray& ray, const HitInfo& hitInfo)
{
    return contributionOfSample(state, light.position, light.color, towardsCamera(ray), ray, hitInfo);
}

glm::vec3 computeContributionSegmentLight(
    RenderState& state, const SegmentLight& light, const Ray& ray, const HitInfo& hitInfo, uint32_t numSamples)
{
    const glm::vec3 cameraDirection = towardsCamera(ray);
    glm::vec3 sum { 0.0f };
    for (uint32_t i = 0; i < numSamples; ++i) {
        glm::vec3 position, color;
        sampleSegmentLight(state.sampler.next_1d(), light, position, color);
        sum += contributionOfSample(state, position, color, cameraDirection, ray, hitInfo);
    }
    return sum / static_cast<float>(numSamples);
}

glm::vec3 computeContributionParallelogramLight(
    RenderState& state, const ParallelogramLight& light, const Ray& ray, const HitInfo& hitInfo, uint32_t numSamples)
{
    const glm::vec3 cameraDirection = towardsCamera(ray);
    glm::vec3 sum { 0.0f };
    for (uint32_t i = 0; i < numSamples; ++i) {
        glm::vec3 position, color;
        sampleParallelogramLight(state.sampler.next_2d(), light, position, color);
        sum += contributionOfSample(state, position, color, cameraDirection, ray, hitInfo);
    }
    return sum / static_cast<float>(numSamples);
}
