#include "bvh_interface.h"
#include "draw.h"
#include "light.h"
#include "shading.h"

const float shadowEpsilon = 1e-4f;

void sampleSegmentLight(const float& sample, const SegmentLight& light, glm::vec3& position, glm::vec3& color)
{
    position = (1 - sample) * light.endpoint0 + sample * light.endpoint1;
    color = (1 - sample) * light.color0 + sample * light.color1;
}

void sampleParallelogramLight(
    const glm::vec2& sample, const ParallelogramLight& light, glm::vec3& position, glm::vec3& color)
{
    const float u = sample.x, v = sample.y;
    position = light.v0 + u * light.edge01 + v * light.edge02;
    color = (1 - u) * (1 - v) * light.color0 + u * (1 - v) * light.color1 + (1 - u) * v * light.color2
        + u * v * light.color3;
}

bool visibilityOfLightSampleBinary(RenderState& state, const glm::vec3& lightPosition, const glm::vec3& lightColor,
    const Ray& ray, const HitInfo& hitInfo)
{
    glm::vec3 point = ray.origin + ray.t * ray.direction + shadowEpsilon * hitInfo.normal;
    float distance = glm::distance(lightPosition, point);
    Ray shadowRay { point, (lightPosition - point) / distance };
    HitInfo blocker;
    if (!state.bvh.intersect(state, shadowRay, blocker))
        return true;
    return shadowRay.t >= distance - shadowEpsilon;
}

static glm::vec3 lightThrough(RenderState& state, const glm::vec3& from, const glm::vec3& to, const glm::vec3& color)
{
    float distance = glm::length(to - from);
    Ray ray { from, glm::normalize(to - from) };
    HitInfo surface;
    if (distance < shadowEpsilon || !state.bvh.intersect(state, ray, surface) || ray.t > distance - shadowEpsilon)
        return color;
    if (surface.material.transparency == 1.0f)
        return glm::vec3(0);
    glm::vec3 left = color * sampleMaterialKd(state, surface) * (1 - surface.material.transparency);
    return lightThrough(state, from + (ray.t + shadowEpsilon) * ray.direction, to, left);
}

glm::vec3 visibilityOfLightSampleTransparency(RenderState& state, const glm::vec3& lightPosition,
    const glm::vec3& lightColor, const Ray& ray, const HitInfo& hitInfo)
{
    glm::vec3 point = ray.origin + ray.t * ray.direction;
    return lightThrough(state, point + shadowEpsilon * hitInfo.normal, lightPosition, lightColor);
}

glm::vec3 computeContributionPointLight(
    RenderState& state, const PointLight& light, const Ray& ray, const HitInfo& hitInfo)
{
    glm::vec3 point = ray.origin + ray.t * ray.direction;
    glm::vec3 lightDirection = glm::normalize(light.position - point);
    drawRay(Ray { point, lightDirection, glm::distance(light.position, point) }, light.color);
    glm::vec3 color = visibilityOfLightSample(state, light.position, light.color, ray, hitInfo);
    return computeShading(state, glm::normalize(-ray.direction), lightDirection, color, hitInfo);
}

glm::vec3 computeContributionSegmentLight(
    RenderState& state, const SegmentLight& light, const Ray& ray, const HitInfo& hitInfo, uint32_t numSamples)
{
    glm::dvec3 sum { 0.0 };
    for (uint32_t i = 0; i < numSamples; i++) {
        PointLight sample;
        sampleSegmentLight(state.sampler.next_1d(), light, sample.position, sample.color);
        sum += glm::dvec3(computeContributionPointLight(state, sample, ray, hitInfo));
    }
    return glm::vec3(sum / static_cast<double>(numSamples));
}

glm::vec3 computeContributionParallelogramLight(
    RenderState& state, const ParallelogramLight& light, const Ray& ray, const HitInfo& hitInfo, uint32_t numSamples)
{
    glm::vec3 mean { 0.0f };
    for (uint32_t i = 0; i < numSamples; i++) {
        PointLight sample;
        sampleParallelogramLight(state.sampler.next_2d(), light, sample.position, sample.color);
        glm::vec3 part = computeContributionPointLight(state, sample, ray, hitInfo);
        mean += (part - mean) / static_cast<float>(i + 1);
    }
    return mean;
}
