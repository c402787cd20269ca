#include "provided/marks.h"
#include "shading.h"

const char provided::lambertianMark = 0;

glm::vec3 computeLambertianModel(RenderState&, const glm::vec3&, const glm::vec3& lightDirection,
    const glm::vec3& lightColor, const HitInfo& hitInfo, const glm::vec3& kd)
{
    const float cosine = glm::dot(hitInfo.normal, lightDirection);
    return cosine <= 0.0f ? glm::vec3(0.0f) : lightColor * kd * cosine;
}
