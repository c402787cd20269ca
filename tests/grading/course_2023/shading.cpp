#include "render.h"
#include "texture.h"
#include <cmath>
#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <glm/gtx/string_cast.hpp>
#include <shading.h>

glm::vec3 sampleMaterialKd(RenderState& state, const HitInfo& hitInfo)
{
    if (state.features.enableTextureMapping && hitInfo.material.kdTexture) {
        if (state.features.enableBilinearTextureFiltering) {
            return sampleTextureBilinear(*hitInfo.material.kdTexture, hitInfo.texCoord);
        } else {
            return sampleTextureNearest(*hitInfo.material.kdTexture, hitInfo.texCoord);
        }
    } else {
        return hitInfo.material.kd;
    }
}

glm::vec3 computeLambertianModel(RenderState& state, const glm::vec3& cameraDirection, const glm::vec3& lightDirection,
    const glm::vec3& lightColor, const HitInfo& hitInfo)
{
    return sampleMaterialKd(state, hitInfo) * lightColor * glm::max(glm::dot(hitInfo.normal, lightDirection), 0.f);
}

glm::vec3 computePhongModel(RenderState& state, const glm::vec3& cameraDirection, const glm::vec3& lightDirection,
    const glm::vec3& lightColor, const HitInfo& hitInfo)
{
    float cosine = glm::dot(hitInfo.normal, lightDirection);
    if (cosine <= 0)
        return glm::vec3 { 0.f };
    glm::vec3 r = glm::reflect(-lightDirection, hitInfo.normal);
    float s = std::pow(glm::max(glm::dot(r, cameraDirection), 0.f), hitInfo.material.shininess);
    return lightColor * (sampleMaterialKd(state, hitInfo) * cosine + hitInfo.material.ks * s);
}

glm::vec3 computeBlinnPhongModel(RenderState& state, const glm::vec3& cameraDirection, const glm::vec3& lightDirection,
    const glm::vec3& lightColor, const HitInfo& hitInfo)
{
    float cosine = glm::dot(hitInfo.normal, lightDirection);
    if (cosine <= 0)
        return glm::vec3 { 0.f };
    glm::vec3 h = glm::normalize(lightDirection + cameraDirection);
    float s = std::pow(glm::max(glm::dot(h, hitInfo.normal), 0.f), hitInfo.material.shininess);
    return lightColor * (sampleMaterialKd(state, hitInfo) * cosine + hitInfo.material.ks * s);
}

glm::vec3 computeShading(RenderState& state, const glm::vec3& cameraDirection, const glm::vec3& lightDirection,
    const glm::vec3& lightColor, const HitInfo& hitInfo)
{
    static LinearGradient gradient = { .components = {
                                           { -1.0f, glm::vec3(1.0f, 0.0f, 0.0f) },
                                           { 1.0f, glm::vec3(0.0f, 1.0f, 1.0f) },
                                       } };
    if (state.features.enableShading) {
        switch (state.features.shadingModel) {
        case ShadingModel::Lambertian:
            return computeLambertianModel(state, cameraDirection, lightDirection, lightColor, hitInfo);
        case ShadingModel::Phong:
            return computePhongModel(state, cameraDirection, lightDirection, lightColor, hitInfo);
        case ShadingModel::BlinnPhong:
            return computeBlinnPhongModel(state, cameraDirection, lightDirection, lightColor, hitInfo);
        case ShadingModel::LinearGradient:
            return computeLinearGradientModel(state, cameraDirection, lightDirection, lightColor, hitInfo, gradient);
        };
    }
    return lightColor * sampleMaterialKd(state, hitInfo);
}

bool byPosition(const LinearGradient::Component& a, const LinearGradient::Component& b)
{
    return a.t < b.t;
}

glm::vec3 LinearGradient::sample(float ti) const
{
    if (components.empty())
        return glm::vec3(0.f);
    std::vector<Component> sorted = components;
    std::sort(sorted.begin(), sorted.end(), byPosition);
    if (ti <= sorted.front().t)
        return sorted.front().color;
    if (ti >= sorted.back().t)
        return sorted.back().color;
    for (int i = 0; i < sorted.size() - 1; i++) {
        if (ti >= sorted[i].t && ti < sorted[i + 1].t) {
            float alpha = (ti - sorted[i].t) / (sorted[i + 1].t - sorted[i].t);
            return (1 - alpha) * sorted[i].color + alpha * sorted[i + 1].color;
        }
    }
    return glm::vec3(0.f);
}

glm::vec3 computeLinearGradientModel(RenderState& state, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo,
    const LinearGradient& gradient)
{
    float cos_theta = glm::dot(lightDirection, hitInfo.normal);
    return lightColor * gradient.sample(glm::clamp(cos_theta, -1.f, 1.f));
}
