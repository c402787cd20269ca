#include "shading.h"

glm::vec3 LinearGradient::sample(float ti) const
{
    const int n = static_cast<int>(components.size());
    if (n == 0)
        return glm::vec3(0.0f);

    std::vector<int> order(n);
    for (int i = 0; i < n; i++)
        order[i] = i;
    for (int i = 0; i < n; i++)
        for (int j = i + 1; j < n; j++)
            if (components[order[j]].t < components[order[i]].t)
                std::swap(order[i], order[j]);

    if (ti <= components[order[0]].t)
        return components[order[0]].color;
    if (ti >= components[order[n - 1]].t)
        return components[order[n - 1]].color;
    for (int i = 0; i < n - 1; i++) {
        const Component& a = components[order[i]];
        const Component& b = components[order[i + 1]];
        if (a.t <= ti && ti <= b.t) {
            if (b.t - a.t < 1e-6f)
                return a.color;
            return a.color + (b.color - a.color) * (ti - a.t) / (b.t - a.t);
        }
    }
    return glm::vec3(0.0f);
}

glm::vec3 computeLinearGradientModel(RenderState& state, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo,
    const LinearGradient& gradient)
{
    float cosTheta = glm::dot(hitInfo.normal, lightDirection);
    if (cosTheta > 1.0f)
        cosTheta = 1.0f;
    if (cosTheta < -1.0f)
        cosTheta = -1.0f;
    return lightColor * gradient.sample(cosTheta);
}

glm::vec3 computeLinearGradientModelComparison(RenderState& state, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo,
    const LinearGradient& gradient)
{
    if (glm::dot(hitInfo.normal, lightDirection) <= 0.0f)
        return lightColor * gradient.sample(0.0f);
    glm::vec3 r = glm::normalize(glm::reflect(-lightDirection, hitInfo.normal));
    glm::vec3 h = glm::normalize(lightDirection + cameraDirection);
    float phong = glm::pow(glm::max(glm::dot(r, cameraDirection), 0.0f), hitInfo.material.shininess);
    float blinnPhong = glm::pow(glm::max(glm::dot(h, hitInfo.normal), 0.0f), hitInfo.material.shininess);
    float ks = (hitInfo.material.ks.x + hitInfo.material.ks.y + hitInfo.material.ks.z) / 3.0f;
    return lightColor * gradient.sample(glm::clamp(ks * (phong - blinnPhong), -1.0f, 1.0f));
}
