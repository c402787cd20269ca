// Weak: this object comes with all of its functions, and a submission may define only some of them.
#include "light.h"
#include "not_written_yet.h"
#include "shading.h"

[[gnu::weak]] void sampleSegmentLight(const float&, const SegmentLight& light, glm::vec3& position, glm::vec3& color)
{
    notWrittenYet("sampleSegmentLight");
    position = light.endpoint0;
    color = light.color0;
}

[[gnu::weak]] void sampleParallelogramLight(
    const glm::vec2&, const ParallelogramLight& light, glm::vec3& position, glm::vec3& color)
{
    notWrittenYet("sampleParallelogramLight");
    position = light.v0;
    color = light.color0;
}

[[gnu::weak]] bool visibilityOfLightSampleBinary(
    RenderState&, const glm::vec3&, const glm::vec3&, const Ray&, const HitInfo&)
{
    notWrittenYet("visibilityOfLightSampleBinary");
    return true;
}

[[gnu::weak]] glm::vec3 visibilityOfLightSampleTransparency(
    RenderState&, const glm::vec3&, const glm::vec3& lightColor, const Ray&, const HitInfo&)
{
    notWrittenYet("visibilityOfLightSampleTransparency");
    return lightColor;
}

[[gnu::weak]] glm::vec3 computeContributionPointLight(
    RenderState& state, const PointLight& light, const Ray& ray, const HitInfo& hitInfo)
{
    notWrittenYet("computeContributionPointLight");
    const glm::vec3 point = ray.origin + ray.t * ray.direction;
    const glm::vec3 lightDirection = glm::normalize(light.position - point);
    return computeShading(state, -glm::normalize(ray.direction), lightDirection, light.color, hitInfo);
}

// An area light that nobody wrote shines like a point light at one of its corners.

[[gnu::weak]] glm::vec3 computeContributionSegmentLight(
    RenderState& state, const SegmentLight& light, const Ray& ray, const HitInfo& hitInfo, uint32_t)
{
    notWrittenYet("computeContributionSegmentLight");
    return computeContributionPointLight(state, { light.endpoint0, light.color0 }, ray, hitInfo);
}

[[gnu::weak]] glm::vec3 computeContributionParallelogramLight(
    RenderState& state, const ParallelogramLight& light, const Ray& ray, const HitInfo& hitInfo, uint32_t)
{
    notWrittenYet("computeContributionParallelogramLight");
    return computeContributionPointLight(state, { light.v0, light.color0 }, ray, hitInfo);
}
