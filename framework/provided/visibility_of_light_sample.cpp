#include "debug/recording.h"
#include "draw.h"
#include "light.h"

static glm::vec3 visible(RenderState& state, const glm::vec3& lightPosition, const glm::vec3& lightColor,
    const Ray& ray, const HitInfo& hitInfo)
{
    if (!state.features.enableShadows)
        return lightColor;
    if (state.features.enableTransparency)
        return visibilityOfLightSampleTransparency(state, lightPosition, lightColor, ray, hitInfo);
    return visibilityOfLightSampleBinary(state, lightPosition, lightColor, ray, hitInfo) ? lightColor : glm::vec3(0.0f);
}

// What comes through green, what is blocked red; the sample in the colour of its light.
static void drawShadowRay(const glm::vec3& lightPosition, const glm::vec3& lightColor, const Ray& ray, bool isBlocked)
{
    const glm::vec3 point = ray.origin + ray.t * ray.direction;
    const glm::vec3 toLight = lightPosition - point;
    const glm::vec3 red { 1.0f, 0.0f, 0.0f }, green { 0.0f, 1.0f, 0.0f };
    drawRay({ point, toLight, 1.0f }, isBlocked ? red : green);
    drawSphere(lightPosition, 0.02f, lightColor);
}

// Apart, so that the usual case needs no stack for it.
[[gnu::noinline]] static glm::vec3 visibleAndWatched(RenderState& state, const glm::vec3& lightPosition,
    const glm::vec3& lightColor, const Ray& ray, const HitInfo& hitInfo)
{
    const debug::TowardsLight way;
    const glm::vec3 light = visible(state, lightPosition, lightColor, ray, hitInfo);
    if (debug::Recording::isOpen())
        drawShadowRay(lightPosition, lightColor, ray, light == glm::vec3(0.0f));
    return light;
}

glm::vec3 visibilityOfLightSample(RenderState& state, const glm::vec3& lightPosition, const glm::vec3& lightColor,
    const Ray& ray, const HitInfo& hitInfo)
{
    if (debug::Watch::isOpen()) [[unlikely]]
        return visibleAndWatched(state, lightPosition, lightColor, ray, hitInfo);
    return visible(state, lightPosition, lightColor, ray, hitInfo);
}
