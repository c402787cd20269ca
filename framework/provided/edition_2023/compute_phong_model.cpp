#include "shading.h"

glm::vec3 computePhongModel(RenderState& state, const glm::vec3& cameraDirection, const glm::vec3& lightDirection,
    const glm::vec3& lightColor, const HitInfo& hitInfo)
{
    return computePhongModel(
        state, cameraDirection, lightDirection, lightColor, hitInfo, sampleMaterialKd(state, hitInfo));
}
