#include "provided/marks.h"
#include "shading.h"

const char provided::phongMark = 0;

glm::vec3 computePhongModel(RenderState&, const glm::vec3& cameraDirection, const glm::vec3& lightDirection,
    const glm::vec3& lightColor, const HitInfo& hitInfo, const glm::vec3& kd)
{
    const float cosine = glm::dot(hitInfo.normal, lightDirection);
    if (cosine <= 0.0f)
        return glm::vec3(0.0f);
    const glm::vec3 mirrored = 2.0f * cosine * hitInfo.normal - lightDirection;
    // Rounding may leave [0, 1], and a high shininess makes much of it.
    const float mirroredCosine = std::clamp(glm::dot(mirrored, cameraDirection), 0.0f, 1.0f);
    const float lobe = std::pow(mirroredCosine, hitInfo.material.shininess);
    return lightColor * (kd * cosine + hitInfo.material.ks * lobe);
}
