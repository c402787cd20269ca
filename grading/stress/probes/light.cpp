#include "light.h"
#include "bvh.h"
#include "grading/stress/probes/answer_all.h"
#include "grading/stress/probes/lights.h"
#include "scene.h"

namespace stress {
namespace {

    using grading::LightSample;

    const worker::Probe segment("stress.segment", [](worker::Call& call) {
        answerAll<SegmentSample>(call, [](const SegmentSample& query) {
            LightSample at {};
            sampleSegmentLight(query.sample, query.light, at.position, at.color);
            return at;
        });
    });

    const worker::Probe parallelogram("stress.parallelogram", [](worker::Call& call) {
        answerAll<ParallelogramSample>(call, [](const ParallelogramSample& query) {
            LightSample at {};
            sampleParallelogramLight(query.sample, query.light, at.position, at.color);
            return at;
        });
    });

    glm::vec3 contributionOf(RenderState& state, const Shining& query)
    {
        const auto& [ray, hitInfo] = query.shaded;
        const ParallelogramLight& light = query.light;
        switch (query.kind) {
        case Shining::Kind::Point:
            return computeContributionPointLight(state, { light.v0, light.color0 }, ray, hitInfo);
        case Shining::Kind::Segment:
            return computeContributionSegmentLight(state,
                { light.v0, light.v0 + light.edge01, light.color0, light.color1 }, ray, hitInfo, query.numSamples);
        case Shining::Kind::Parallelogram:
            return computeContributionParallelogramLight(state, light, ray, hitInfo, query.numSamples);
        }
        return glm::vec3(0.0f);
    }

    const worker::Probe contribution("stress.contribution", [](worker::Call& call) {
        const Scene scene;
        Features features { .enableShading = true, .enableShadows = true, .enableAccelStructure = true };
        const BVH bvh(scene, features);
        answerAll<Shining>(call, [&](const Shining& query) {
            features.shadingModel = query.model;
            RenderState state { scene, features, bvh, Sampler(1) };
            return contributionOf(state, query);
        });
    });

}
}
