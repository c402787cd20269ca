#include "accel/counting_bvh.h"
#include "light.h"

bool canBeLit(
    const RenderState& state, const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo)
{
    if (state.needs.lightFromBehind)
        return true;
    constexpr glm::vec3 black { 0.0f };
    const Material& material = hitInfo.material;
    const bool isBelow = glm::dot(hitInfo.normal, lightDirection) <= 0.0f; // not if that is NaN, which is to be seen
    if (!isBelow && lightColor != black && (material.kdTexture || material.kd != black || material.ks != black))
        return true;
    accel::CountingBVH::addUnlit();
    return false;
}
