#include "shading.h"

glm::vec3 LinearGradient::sample(float ti) const
{
    // One pass finds the neighbours of ti: no order is assumed, nothing is copied.
    const Component* below = nullptr;
    const Component* above = nullptr;
    for (const Component& component : components) {
        if (component.t <= ti && (!below || component.t > below->t))
            below = &component;
        if (component.t >= ti && (!above || component.t < above->t))
            above = &component;
    }
    if (!below && !above)
        return glm::vec3(0.0f);
    if (!below || !above)
        return below ? below->color : above->color;
    const float gap = above->t - below->t;
    if (gap == 0.0f) // ti is a component's position
        return below->color;
    return glm::mix(below->color, above->color, (ti - below->t) / gap);
}

glm::vec3 computeLinearGradientModel(RenderState&, const glm::vec3&, const glm::vec3& lightDirection,
    const glm::vec3& lightColor, const HitInfo& hitInfo, const LinearGradient& gradient)
{
    const float cosine = glm::dot(hitInfo.normal, lightDirection);
    return lightColor * gradient.sample(std::clamp(cosine, -1.0f, 1.0f)); // rounding may leave [-1, 1]
}

// The specular lobe of each model, in [0, 1], for a light in front of the surface.

static float phongLobe(const glm::vec3& view, const glm::vec3& light, const glm::vec3& normal, float shininess)
{
    const glm::vec3 mirrored = 2.0f * glm::dot(normal, light) * normal - light;
    return std::pow(std::clamp(glm::dot(mirrored, view), 0.0f, 1.0f), shininess);
}

static float blinnPhongLobe(const glm::vec3& view, const glm::vec3& light, const glm::vec3& normal, float shininess)
{
    const glm::vec3 sum = view + light;
    const float length = glm::length(sum);
    if (length == 0.0f) // the view from opposite the light has no halfway vector
        return 0.0f;
    return std::pow(std::clamp(glm::dot(normal, sum) / length, 0.0f, 1.0f), shininess);
}

glm::vec3 computeLinearGradientModelComparison(RenderState&, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo,
    const LinearGradient& gradient)
{
    // The difference keeps its sign, so that both halves of the gradient are reached: below 0 Phong is brighter, above
    // 0 Blinn-Phong is.
    float difference = 0.0f;
    if (glm::dot(hitInfo.normal, lightDirection) > 0.0f) {
        const float shininess = hitInfo.material.shininess;
        difference = blinnPhongLobe(cameraDirection, lightDirection, hitInfo.normal, shininess)
            - phongLobe(cameraDirection, lightDirection, hitInfo.normal, shininess);
    }
    return lightColor * gradient.sample(difference);
}
