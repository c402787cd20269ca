#include "shading.h"

// Each component's colour counts fully at its position and nothing at its neighbours'.
glm::vec3 LinearGradient::sample(float ti) const
{
    glm::dvec3 color(0.0);
    double sum = 0.0;
    for (const Component& component : components) {
        double before = -1e30, after = 1e30; // the neighbours' positions
        bool isFirst = true; // of those at this position
        for (const Component& other : components) {
            if (other.t == component.t && &other < &component)
                isFirst = false;
            if (other.t < component.t)
                before = std::max(before, static_cast<double>(other.t));
            if (other.t > component.t)
                after = std::min(after, static_cast<double>(other.t));
        }
        double weight = 0.0;
        if (ti <= component.t && ti > before)
            weight = before == -1e30 ? 1.0 : (ti - before) / (component.t - before);
        else if (ti > component.t && ti < after)
            weight = after == 1e30 ? 1.0 : (after - ti) / (after - component.t);

        if (!isFirst)
            continue;
        color += weight * glm::dvec3(component.color);
        sum += weight;
    }
    return sum > 0.0 ? glm::vec3(color / sum) : glm::vec3(0.0f);
}

glm::vec3 computeLinearGradientModel(RenderState& state, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo,
    const LinearGradient& gradient)
{
    const float cosine = std::min(1.0f, std::max(-1.0f, glm::dot(lightDirection, hitInfo.normal)));
    const glm::vec3 color = gradient.sample(cosine);
    return { lightColor.x * color.x, lightColor.y * color.y, lightColor.z * color.z };
}

glm::vec3 computeLinearGradientModelComparison(RenderState& state, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo,
    const LinearGradient& gradient)
{
    const glm::vec3 kd = sampleMaterialKd(state, hitInfo);
    const glm::vec3 difference = computePhongModel(state, cameraDirection, lightDirection, lightColor, hitInfo, kd)
        - computeBlinnPhongModel(state, cameraDirection, lightDirection, lightColor, hitInfo, kd);
    return gradient.sample(glm::clamp((difference.r + difference.g + difference.b) / 3.0f, -1.0f, 1.0f));
}
