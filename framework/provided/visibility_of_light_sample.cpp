#include "light.h"

glm::vec3 visibilityOfLightSample(RenderState& state, const glm::vec3& lightPosition, const glm::vec3& lightColor,
    const Ray& ray, const HitInfo& hitInfo)
{
    if (!state.features.enableShadows)
        return lightColor;
    if (state.features.enableTransparency)
        return visibilityOfLightSampleTransparency(state, lightPosition, lightColor, ray, hitInfo);
    return visibilityOfLightSampleBinary(state, lightPosition, lightColor, ray, hitInfo) ? lightColor : glm::vec3(0.0f);
}
