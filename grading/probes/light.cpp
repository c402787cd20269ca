#include "light.h"
#include "bvh.h"
#include "grading/probes/light_sample.h"
#include "grading/probes/stage.h"
#include "worker/probe.h"
#include <framework/variant_helper.h>

namespace grading {
namespace {

    // light, samples -> light samples
    template <typename Light, typename Sample, typename F> void sampleAll(worker::Call& call, const F& sampleLight)
    {
        const auto light = call.input.read<Light>();
        std::vector<LightSample> result;
        for (const Sample& sample : call.input.read<std::vector<Sample>>()) {
            LightSample& at = result.emplace_back();
            sampleLight(sample, light, at.position, at.color);
        }
        call.output << result;
    }

    const worker::Probe segment(
        "light.sample_segment", [](worker::Call& call) { sampleAll<SegmentLight, float>(call, sampleSegmentLight); });
    const worker::Probe parallelogram("light.sample_parallelogram",
        [](worker::Call& call) { sampleAll<ParallelogramLight, glm::vec2>(call, sampleParallelogramLight); });

    // A stage with its tree.
    struct World {
        explicit World(worker::Reader& input)
            : stage(input.read<Stage>())
            , bvh(stage.scene, stage.features)
        {
        }

        [[nodiscard]] RenderState state(uint32_t seed = 1) const
        {
            return { stage.scene, stage.features, bvh, Sampler(seed) };
        }

        Stage stage;
        BVH bvh;
    };

    // stage, light sample -> 1 if visible, 0 if not
    const worker::Probe binary("light.binary", [](worker::Call& call) {
        const World world(call.input);
        const auto [position, color] = call.input.read<LightSample>();
        RenderState state = world.state();
        const auto& [ray, hitInfo] = world.stage.shaded;
        const bool isVisible = visibilityOfLightSampleBinary(state, position, color, ray, hitInfo);
        call.output << static_cast<uint8_t>(isVisible);
    });

    // stage, light sample -> colour
    const worker::Probe transparency("light.transparency", [](worker::Call& call) {
        const World world(call.input);
        const auto [position, color] = call.input.read<LightSample>();
        RenderState state = world.state();
        const auto& [ray, hitInfo] = world.stage.shaded;
        call.output << visibilityOfLightSampleTransparency(state, position, color, ray, hitInfo);
    });

    glm::vec3 contributionOf(
        RenderState& state, const Scene::SceneLight& light, const Incidence& shaded, uint32_t numSamples)
    {
        const auto& [ray, hitInfo] = shaded;
        return std::visit(
            make_visitor([&](const PointLight& l) { return computeContributionPointLight(state, l, ray, hitInfo); },
                [&](const SegmentLight& l) {
                    return computeContributionSegmentLight(state, l, ray, hitInfo, numSamples);
                },
                [&](const ParallelogramLight& l) {
                    return computeContributionParallelogramLight(state, l, ray, hitInfo, numSamples);
                }),
            light);
    }

    // stage with one light, number of samples, seeds -> colours
    const worker::Probe contribution("light.contribution", [](worker::Call& call) {
        const World world(call.input);
        const auto numSamples = call.input.read<uint32_t>();
        std::vector<glm::vec3> colors;
        for (const uint32_t seed : call.input.read<std::vector<uint32_t>>()) {
            RenderState state = world.state(seed);
            colors.push_back(contributionOf(state, world.stage.scene.lights.at(0), world.stage.shaded, numSamples));
        }
        call.output << colors;
    });

}
}
