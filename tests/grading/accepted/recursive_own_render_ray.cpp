#include "bvh_interface.h"
#include "draw.h"
#include "extra.h"
#include "light.h"
#include "recursive.h"

// A file as the course has them: renderRay stands in it.
glm::vec3 renderRay(RenderState& state, Ray ray, int rayDepth)
{
    HitInfo hit;
    const bool found = state.bvh.intersect(state, ray, hit);
    if (!found)
        return sampleEnvironmentMap(state, ray);

    glm::vec3 color = computeLightContribution(state, ray, hit);
    if (rayDepth < 6) {
        const bool isMirror = hit.material.ks.r > 0 || hit.material.ks.g > 0 || hit.material.ks.b > 0;
        if (state.features.enableReflections && isMirror)
            renderRaySpecularComponent(state, ray, hit, color, rayDepth);
        if (state.features.enableTransparency && hit.material.transparency < 1)
            renderRayTransparentComponent(state, ray, hit, color, rayDepth);
    }
    return color;
}

static constexpr float kOffset = 0.0005f;

static Ray rayFrom(const Ray& incoming, const glm::vec3& direction)
{
    Ray result;
    result.direction = glm::normalize(direction);
    result.origin = incoming.origin + incoming.direction * incoming.t + result.direction * kOffset;
    return result;
}

Ray generateReflectionRay(Ray ray, HitInfo hitInfo)
{
    const auto outwards = -ray.direction;
    return rayFrom(ray, 2 * glm::dot(hitInfo.normal, outwards) * hitInfo.normal - outwards);
}

Ray generatePassthroughRay(Ray ray, HitInfo)
{
    return rayFrom(ray, ray.direction);
}

void renderRaySpecularComponent(RenderState& state, Ray ray, const HitInfo& hitInfo, glm::vec3& hitColor, int rayDepth)
{
    const glm::vec3 mirrored = renderRay(state, generateReflectionRay(ray, hitInfo), rayDepth + 1);
    hitColor.r += mirrored.r * hitInfo.material.ks.r;
    hitColor.g += mirrored.g * hitInfo.material.ks.g;
    hitColor.b += mirrored.b * hitInfo.material.ks.b;
}

void renderRayTransparentComponent(
    RenderState& state, Ray ray, const HitInfo& hitInfo, glm::vec3& hitColor, int rayDepth)
{
    const glm::vec3 behind = renderRay(state, generatePassthroughRay(ray, hitInfo), rayDepth + 1);
    hitColor = behind + hitInfo.material.transparency * (hitColor - behind);
}
