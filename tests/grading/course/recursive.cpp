#include "recursive.h"
#include "bvh_interface.h"
#include "draw.h"
#include "extra.h"
#include "intersect.h"
#include "light.h"
#include <iostream>

glm::vec3 renderRays(RenderState& state, std::span<const Ray> rays, int rayDepth)
{
    glm::vec3 L { 0.f };
    for (const auto& ray : rays) {
        L += renderRay(state, ray, rayDepth);
    }
    return L / static_cast<float>(rays.size());
}

glm::vec3 renderRay(RenderState& state, Ray ray, int rayDepth)
{
    HitInfo hitInfo;
    if (!state.bvh.intersect(state, ray, hitInfo)) {
        drawRay(ray, glm::vec3(1, 0, 0));
        return sampleEnvironmentMap(state, ray);
    }
    glm::vec3 Lo = computeLightContribution(state, ray, hitInfo);
    drawRay(ray, glm::vec3(1.0f));
    if (rayDepth < 6) {
        bool isReflective = glm::any(glm::notEqual(hitInfo.material.ks, glm::vec3(0.0f)));
        bool isTransparent = hitInfo.material.transparency != 1.f;
        if (state.features.enableReflections && !state.features.extra.enableGlossyReflection && isReflective) {
            renderRaySpecularComponent(state, ray, hitInfo, Lo, rayDepth);
        }
        if (state.features.enableReflections && state.features.extra.enableGlossyReflection && isReflective) {
            renderRayGlossyComponent(state, ray, hitInfo, Lo, rayDepth);
        }
        if (state.features.enableTransparency && isTransparent) {
            renderRayTransparentComponent(state, ray, hitInfo, Lo, rayDepth);
        }
    }
    return Lo;
}

Ray generateReflectionRay(Ray ray, HitInfo hitInfo)
{
    Ray r {};
    glm::vec3 d = glm::normalize(ray.direction);
    r.direction = glm::normalize(d - 2.0f * glm::dot(d, hitInfo.normal) * hitInfo.normal);
    r.origin = ray.origin + ray.t * ray.direction + r.direction * 1e-4f;
    r.t = std::numeric_limits<float>::max();
    return r;
}

Ray generatePassthroughRay(Ray ray, HitInfo hitInfo)
{
    glm::vec3 newOrigin = ray.origin + ray.direction * (ray.t + 0.0001f);
    return Ray(newOrigin, ray.direction);
}

void renderRaySpecularComponent(RenderState& state, Ray ray, const HitInfo& hitInfo, glm::vec3& hitColor, int rayDepth)
{
    Ray r = generateReflectionRay(ray, hitInfo);
    hitColor += renderRay(state, r, rayDepth + 1) * hitInfo.material.ks;
    if (state.features.enableDebugDraw) {
        HitInfo newHit;
        state.bvh.intersect(state, r, newHit);
        drawRay(r, glm::vec3 { 0, 1, 0 });
    }
}

void renderRayTransparentComponent(
    RenderState& state, Ray ray, const HitInfo& hitInfo, glm::vec3& hitColor, int rayDepth)
{
    Ray r = generatePassthroughRay(ray, hitInfo);
    float alpha = hitInfo.material.transparency;
    hitColor = hitColor * alpha + (1 - alpha) * renderRay(state, r, rayDepth + 1);
}
