#include "provided/marks.h"
#include "shading.h"

const char provided::shadingMark = 0;

namespace {

// From magenta behind the surface over blue and green to yellow facing the light: every step can be told apart.
const LinearGradient gradient { .components = {
                                    { -1.0f, { 0.8f, 0.1f, 0.6f } },
                                    { -0.3f, { 0.2f, 0.1f, 0.5f } },
                                    { 0.0f, { 0.1f, 0.3f, 0.8f } },
                                    { 0.5f, { 0.1f, 0.7f, 0.4f } },
                                    { 1.0f, { 1.0f, 0.9f, 0.3f } },
                                } };

// Red where Phong is brighter, blue where Blinn-Phong is, green where neither.
const LinearGradient comparison { .components = {
                                      { -1.0f, { 0.9f, 0.1f, 0.1f } },
                                      { 0.0f, { 0.1f, 0.7f, 0.1f } },
                                      { 1.0f, { 0.1f, 0.1f, 0.9f } },
                                  } };

}

// By the model that is switched on, on a surface of this colour.
static glm::vec3 shade(RenderState& state, const glm::vec3& cameraDirection, const glm::vec3& lightDirection,
    const glm::vec3& lightColor, const HitInfo& hitInfo, const glm::vec3& kd)
{
    if (!state.features.enableShading)
        return lightColor * kd;
    switch (state.features.shadingModel) {
    case ShadingModel::Lambertian:
        return computeLambertianModel(state, cameraDirection, lightDirection, lightColor, hitInfo, kd);
    case ShadingModel::Phong:
        return computePhongModel(state, cameraDirection, lightDirection, lightColor, hitInfo, kd);
    case ShadingModel::BlinnPhong:
        return computeBlinnPhongModel(state, cameraDirection, lightDirection, lightColor, hitInfo, kd);
    case ShadingModel::LinearGradient:
        return computeLinearGradientModel(state, cameraDirection, lightDirection, lightColor, hitInfo, gradient);
    case ShadingModel::LinearGradientComparison:
        return computeLinearGradientModelComparison(
            state, cameraDirection, lightDirection, lightColor, hitInfo, comparison);
    }
    return glm::vec3(0.0f);
}

// No texture is looked up for nothing.
static bool needsLookup(const RenderState& state)
{
    const Features& features = state.features;
    return state.needs.textures && !(features.enableShading && isByGradient(features.shadingModel));
}

// Apart, so that the usual case needs no stack for it.
[[gnu::noinline]] static glm::vec3 shadeTextured(RenderState& state, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo)
{
    const glm::vec3 kd = sampleMaterialKd(state, hitInfo);
    return shade(state, cameraDirection, lightDirection, lightColor, hitInfo, kd);
}

glm::vec3 computeShading(RenderState& state, const glm::vec3& cameraDirection, const glm::vec3& lightDirection,
    const glm::vec3& lightColor, const HitInfo& hitInfo)
{
    if (needsLookup(state))
        return shadeTextured(state, cameraDirection, lightDirection, lightColor, hitInfo);
    return shade(state, cameraDirection, lightDirection, lightColor, hitInfo, hitInfo.material.kd);
}
