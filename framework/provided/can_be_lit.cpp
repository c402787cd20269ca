#include "accel/counting_bvh.h"
#include "light.h"

static bool isBlack(const glm::vec3& color)
{
    return color.x == 0.0f && color.y == 0.0f && color.z == 0.0f; // most often the first says it
}

static bool isDull(const Material& material)
{
    return isBlack(material.kd) && isBlack(material.ks) && !material.kdTexture;
}

bool canBeLit(
    const RenderState& state, const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo)
{
    if (state.needs.lightFromBehind)
        return true;
    const bool isBelow = glm::dot(hitInfo.normal, lightDirection) <= 0.0f; // not if that is NaN, which is to be seen
    if (!isBelow && !isBlack(lightColor) && !isDull(hitInfo.material))
        return true;
    accel::CountingBVH::addUnlit();
    return false;
}
