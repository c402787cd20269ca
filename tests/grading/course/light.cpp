#include "light.h"
#include "bvh_interface.h"
#include "config.h"
#include "draw.h"
#include "intersect.h"
#include "render.h"
#include "scene.h"
#include "shading.h"
// Suppress warnings in third-party code.
#include <framework/disable_all_warnings.h>
DISABLE_WARNINGS_PUSH()
#include <glm/geometric.hpp>
#include <iostream>
DISABLE_WARNINGS_POP()

void sampleSegmentLight(const float& sample, const SegmentLight& light, glm::vec3& position, glm::vec3& color)
{
    position = light.endpoint0 + sample * (light.endpoint1 - light.endpoint0);
    color = light.color0 + sample * (light.color1 - light.color0);
}

void sampleParallelogramLight(
    const glm::vec2& sample, const ParallelogramLight& light, glm::vec3& position, glm::vec3& color)
{
    position = light.v0 + sample.x * light.edge01 + sample.y * light.edge02;
    float alpha = sample[0], beta = sample[1];
    color = light.color0 * (1 - alpha) * (1 - beta) + light.color1 * alpha * (1 - beta)
        + light.color2 * (1 - alpha) * beta + light.color3 * alpha * beta;
}

bool visibilityOfLightSampleBinary(RenderState& state, const glm::vec3& lightPosition, const glm::vec3& lightColor,
    const Ray& ray, const HitInfo& hitInfo)
{
    if (!state.features.enableShadows) {
        return true;
    } else {
        glm::vec3 p = ray.origin + ray.t * ray.direction + hitInfo.normal * 1e-4f;
        Ray shadowRay { p, glm::normalize(lightPosition - p) };
        HitInfo shadowHit;
        float distance = glm::length(lightPosition - p);
        return !(state.bvh.intersect(state, shadowRay, shadowHit) && shadowRay.t < distance);
    }
}

glm::vec3 visibilityOfLightSampleTransparency(RenderState& state, const glm::vec3& lightPosition,
    const glm::vec3& lightColor, const Ray& ray, const HitInfo& hitInfo)
{
    glm::vec3 result = lightColor;
    glm::vec3 p = ray.origin + ray.t * ray.direction + hitInfo.normal * 1e-4f;
    glm::vec3 d = glm::normalize(lightPosition - p);
    while (true) {
        Ray shadowRay;
        shadowRay.origin = p;
        shadowRay.direction = d;
        HitInfo shadowHit;
        if (!state.bvh.intersect(state, shadowRay, shadowHit) || shadowRay.t >= glm::length(lightPosition - p))
            return result;
        result *= sampleMaterialKd(state, shadowHit) * (1 - shadowHit.material.transparency);
        if (result == glm::vec3(0))
            return result;
        p = shadowRay.origin + (shadowRay.t + 1e-4f) * shadowRay.direction;
    }
}

glm::vec3 visibilityOfLightSample(RenderState& state, const glm::vec3& lightPosition, const glm::vec3& lightColor,
    const Ray& ray, const HitInfo& hitInfo)
{
    if (!state.features.enableShadows) {
        return lightColor;
    } else if (!state.features.enableTransparency) {
        return visibilityOfLightSampleBinary(state, lightPosition, lightColor, ray, hitInfo) ? lightColor
                                                                                             : glm::vec3(0);
    } else {
        return visibilityOfLightSampleTransparency(state, lightPosition, lightColor, ray, hitInfo);
    }
}

glm::vec3 computeContributionPointLight(
    RenderState& state, const PointLight& light, const Ray& ray, const HitInfo& hitInfo)
{
    glm::vec3 p = ray.origin + ray.t * ray.direction;
    glm::vec3 l = glm::normalize(light.position - p);
    glm::vec3 v = -ray.direction;
    glm::vec3 visible = visibilityOfLightSample(state, light.position, light.color, ray, hitInfo);
    return computeShading(state, v, l, visible, hitInfo);
}

glm::vec3 computeContributionSegmentLight(
    RenderState& state, const SegmentLight& light, const Ray& ray, const HitInfo& hitInfo, uint32_t numSamples)
{
    glm::vec3 sum(0.0f);
    for (int i = 0; i < numSamples; i++) {
        PointLight sampled;
        sampleSegmentLight(state.sampler.next_1d(), light, sampled.position, sampled.color);
        sum += computeContributionPointLight(state, sampled, ray, hitInfo);
    }
    return sum / static_cast<float>(numSamples);
}

glm::vec3 computeContributionParallelogramLight(
    RenderState& state, const ParallelogramLight& light, const Ray& ray, const HitInfo& hitInfo, uint32_t numSamples)
{
    glm::vec3 sum(0.0f);
    for (int i = 0; i < numSamples; i++) {
        glm::vec3 position, color;
        sampleParallelogramLight({ state.sampler.next_1d(), state.sampler.next_1d() }, light, position, color);
        sum += computeContributionPointLight(state, PointLight { .position = position, .color = color }, ray, hitInfo);
    }
    return sum / static_cast<float>(numSamples);
}

glm::vec3 computeLightContribution(RenderState& state, const Ray& ray, const HitInfo& hitInfo)
{
    glm::vec3 Lo { 0.0f };
    for (const auto& light : state.scene.lights) {
        if (std::holds_alternative<PointLight>(light)) {
            Lo += computeContributionPointLight(state, std::get<PointLight>(light), ray, hitInfo);
        } else if (std::holds_alternative<SegmentLight>(light)) {
            Lo += computeContributionSegmentLight(
                state, std::get<SegmentLight>(light), ray, hitInfo, state.features.numShadowSamples);
        } else if (std::holds_alternative<ParallelogramLight>(light)) {
            Lo += computeContributionParallelogramLight(
                state, std::get<ParallelogramLight>(light), ray, hitInfo, state.features.numShadowSamples);
        }
    }
    return Lo;
}
