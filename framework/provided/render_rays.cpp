#include "recursive.h"

glm::vec3 renderRays(RenderState& state, std::span<const Ray> rays, int rayDepth)
{
    glm::vec3 sum { 0.0f };
    for (const Ray& ray : rays)
        sum += renderRay(state, ray, rayDepth);
    return rays.empty() ? sum : sum / static_cast<float>(rays.size());
}
