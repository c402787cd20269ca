#include "provided/marks.h"
#include "shading.h"

const char provided::blinnPhongMark = 0;

glm::vec3 computeBlinnPhongModel(RenderState&, const glm::vec3& cameraDirection, const glm::vec3& lightDirection,
    const glm::vec3& lightColor, const HitInfo& hitInfo, const glm::vec3& kd)
{
    const float cosine = glm::dot(hitInfo.normal, lightDirection);
    if (cosine <= 0.0f)
        return glm::vec3(0.0f);
    const glm::vec3 sum = lightDirection + cameraDirection;
    const float length = glm::length(sum); // 0 where the camera looks from opposite the light: no halfway vector
    // Rounding may leave [0, 1], and a high shininess makes much of it.
    const float halfwayCosine = length > 0.0f ? std::clamp(glm::dot(hitInfo.normal, sum) / length, 0.0f, 1.0f) : 0.0f;
    return lightColor * (kd * cosine + hitInfo.material.ks * std::pow(halfwayCosine, hitInfo.material.shininess));
}
