#include "accel/light_shaft.h"
#include "light.h"
#include "scene.h"
#include "values/even_numbers.h"
#include <framework/variant_helper.h>

glm::vec3 computeLightContribution(RenderState& state, const Ray& ray, const HitInfo& hitInfo)
{
    const uint32_t numSamples = state.features.numShadowSamples;
    const auto contribution = make_visitor(
        [&](const PointLight& light) { return computeContributionPointLight(state, light, ray, hitInfo); },
        [&](const SegmentLight& light) {
            if (values::EvenNumbers* even = state.sampler.even())
                even->expectNumbers(numSamples);
            if (state.shaft)
                state.shaft->aimAt(light, numSamples);
            return computeContributionSegmentLight(state, light, ray, hitInfo, numSamples);
        },
        [&](const ParallelogramLight& light) {
            if (values::EvenNumbers* even = state.sampler.even())
                even->expectPoints(numSamples);
            if (state.shaft)
                state.shaft->aimAt(light, numSamples);
            return computeContributionParallelogramLight(state, light, ray, hitInfo, numSamples);
        });
    glm::vec3 sum { 0.0f };
    for (const Scene::SceneLight& light : state.scene.lights)
        sum += std::visit(contribution, light);
    return sum;
}
