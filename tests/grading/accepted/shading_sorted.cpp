#include "shading.h"

glm::vec3 LinearGradient::sample(float ti) const
{
    if (components.empty())
        return glm::vec3(0.0f);
    std::vector<Component> sorted = components;
    std::sort(sorted.begin(), sorted.end(), [](const Component& a, const Component& b) { return a.t < b.t; });

    auto right = std::lower_bound(
        sorted.begin(), sorted.end(), ti, [](const Component& component, float t) { return component.t < t; });
    if (right == sorted.begin())
        return sorted.front().color;
    if (right == sorted.end())
        return sorted.back().color;
    auto left = right - 1; // its t is less than ti: the gap is not 0
    float alpha = (ti - left->t) / (right->t - left->t);
    return left->color * (1.0f - alpha) + right->color * alpha;
}

glm::vec3 computeLinearGradientModel(RenderState& state, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo,
    const LinearGradient& gradient)
{
    float cosTheta = glm::dot(glm::normalize(lightDirection), glm::normalize(hitInfo.normal));
    return gradient.sample(glm::clamp(cosTheta, -1.0f, 1.0f)) * lightColor;
}

glm::vec3 computeLinearGradientModelComparison(RenderState& state, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo,
    const LinearGradient& gradient)
{
    const glm::vec3 kd(0.0f); // the diffuse terms are the same
    glm::vec3 phong = computePhongModel(state, cameraDirection, lightDirection, glm::vec3(1.0f), hitInfo, kd);
    glm::vec3 blinnPhong = computeBlinnPhongModel(state, cameraDirection, lightDirection, glm::vec3(1.0f), hitInfo, kd);
    return lightColor * gradient.sample(glm::length(phong) - glm::length(blinnPhong));
}
