#include "light.h"
#include "bvh.h"
#include "grading/probes/shaded_point.h"
#include "worker/probe.h"
#include "worker/scene_message.h"
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

    // A point that is shaded in a scene, as it was sent: scene, features, shaded point.
    struct Stage {
        explicit Stage(worker::Reader& input)
            : scene(input.read<Scene>())
            , features(input.read<Features>())
            , shaded(input.read<ShadedPoint>())
            , bvh(scene, features)
        {
            shaded.hitInfo.material.kdTexture = nullptr;
        }

        [[nodiscard]] RenderState state(uint32_t seed = 1) const { return { scene, features, bvh, Sampler(seed) }; }

        Scene scene;
        Features features;
        ShadedPoint shaded;
        BVH bvh;
    };

    // stage, light sample -> 1 if visible, 0 if not
    const worker::Probe binary("light.binary", [](worker::Call& call) {
        const Stage stage(call.input);
        const auto [position, color] = call.input.read<LightSample>();
        RenderState state = stage.state();
        const bool isVisible
            = visibilityOfLightSampleBinary(state, position, color, stage.shaded.ray, stage.shaded.hitInfo);
        call.output << static_cast<uint8_t>(isVisible);
    });

    // stage, light sample -> colour
    const worker::Probe transparency("light.transparency", [](worker::Call& call) {
        const Stage stage(call.input);
        const auto [position, color] = call.input.read<LightSample>();
        RenderState state = stage.state();
        call.output << visibilityOfLightSampleTransparency(
            state, position, color, stage.shaded.ray, stage.shaded.hitInfo);
    });

    glm::vec3 contributionOf(
        RenderState& state, const Scene::SceneLight& light, const ShadedPoint& shaded, uint32_t numSamples)
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
        const Stage stage(call.input);
        const auto numSamples = call.input.read<uint32_t>();
        std::vector<glm::vec3> colors;
        for (const uint32_t seed : call.input.read<std::vector<uint32_t>>()) {
            RenderState state = stage.state(seed);
            colors.push_back(contributionOf(state, stage.scene.lights.at(0), stage.shaded, numSamples));
        }
        call.output << colors;
    });

}
}
