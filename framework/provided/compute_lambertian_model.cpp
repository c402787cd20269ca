#include "provided/marks.h"
#include "shading.h"

const char provided::lambertianMark = 0;

glm::vec3 computeLambertianModel(RenderState&, const glm::vec3&, const glm::vec3& lightDirection,
    const glm::vec3& lightColor, const HitInfo& hitInfo, const glm::vec3& kd)
{
    return lightColor * kd * std::max(glm::dot(hitInfo.normal, lightDirection), 0.0f);
}
