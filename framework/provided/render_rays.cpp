#include "recursive.h"
#include "values/even_numbers.h"

glm::vec3 renderRays(RenderState& state, std::span<const Ray> rays, int rayDepth)
{
    glm::vec3 sum { 0.0f };
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (values::EvenNumbers* even = state.sampler.even())
            even->startRay(static_cast<uint32_t>(i));
        sum += renderRay(state, rays[i], rayDepth);
    }
    return rays.empty() ? sum : sum / static_cast<float>(rays.size());
}
