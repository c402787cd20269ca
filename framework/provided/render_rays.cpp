#include "accel/expected_rays.h"
#include "provided/marks.h"
#include "recursive.h"
#include "values/even_numbers.h"

const char provided::raysMark = 0;

glm::vec3 renderRays(RenderState& state, std::span<const Ray> rays, int rayDepth)
{
    glm::dvec3 sum { 0.0 }; // in float, a million rays would lose percents
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (state.expected && i % accel::ExpectedRays::most == 0)
            state.expected->expect(rays.subspan(i));
        if (values::EvenNumbers* even = state.sampler.even())
            even->startRay(static_cast<uint32_t>(i));
        sum += glm::dvec3(renderRay(state, rays[i], rayDepth));
    }
    return rays.empty() ? glm::vec3(0.0f) : glm::vec3(sum / static_cast<double>(rays.size()));
}
