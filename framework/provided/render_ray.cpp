#include "bvh_interface.h"
#include "debug/recording.h"
#include "draw.h"
#include "extra.h"
#include "light.h"
#include "recursive.h"

glm::vec3 renderRay(RenderState& state, Ray ray, int rayDepth)
{
    const debug::Because bounce(rayDepth);

    HitInfo hitInfo;
    if (!state.bvh.intersect(state, ray, hitInfo)) {
        if (debug::Recording::isOpen()) [[unlikely]]
            drawRay(ray, glm::vec3(1.0f, 0.0f, 0.0f));
        return state.features.extra.enableEnvironmentMap ? sampleEnvironmentMap(state, ray) : glm::vec3(0.0f);
    }
    if (debug::Recording::isOpen()) [[unlikely]] {
        drawRay(ray);
        debug::Recording::addHit(ray, hitInfo);
    }

    glm::vec3 color = computeLightContribution(state, ray, hitInfo);
    if (rayDepth >= static_cast<int>(state.features.extra.maxDepth))
        return color;
    if (state.features.enableReflections && hitInfo.material.ks != glm::vec3(0.0f)) {
        if (state.features.extra.enableGlossyReflection)
            renderRayGlossyComponent(state, ray, hitInfo, color, rayDepth);
        else
            renderRaySpecularComponent(state, ray, hitInfo, color, rayDepth);
    }
    if (state.features.enableTransparency && hitInfo.material.transparency != 1.0f)
        renderRayTransparentComponent(state, ray, hitInfo, color, rayDepth);
    return color;
}
