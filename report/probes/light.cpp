#include "light.h"
#include "bvh.h"
#include "report/probes/light_question.h"
#include "scene.h"
#include "worker/probe.h"

namespace report {
namespace {

    LightSample sampleAt(const glm::vec2& sample, const ParallelogramLight& light)
    {
        LightSample at {};
        sampleParallelogramLight(sample, light, at.position, at.color);
        return at;
    }

    // LightSamplesQuestion -> LightSamples
    const worker::Probe samples("figures.light_samples", [](worker::Call& call) {
        const auto question = call.input.read<LightSamplesQuestion>();
        Sampler twice(question.seedTwice1d), once(question.seed2d);
        LightSamples answer;
        for (uint32_t i = 0; i < question.number; ++i) {
            const float x = twice.next_1d(); // before y, whatever the compiler's order of arguments
            const float y = twice.next_1d();
            answer.twice1d.push_back(sampleAt({ x, y }, question.light));
            answer.once2d.push_back(sampleAt(once.next_2d(), question.light));
        }
        call.output << answer;
    });

    // Level, at height 1, above the point that is lit from height 2.
    Scene paneOf(const glm::vec3& kd, float alpha)
    {
        const glm::vec3 up { 0.0f, 1.0f, 0.0f };
        Scene scene;
        Mesh& pane = scene.meshes.emplace_back();
        for (const glm::vec3 corner : { glm::vec3(-3, 1, -1), glm::vec3(3, 1, -1), glm::vec3(0, 1, 3) })
            pane.vertices.push_back({ corner, up, {} });
        pane.triangles.emplace_back(0, 1, 2);
        pane.material.kd = kd;
        pane.material.transparency = alpha;
        return scene;
    }

    glm::vec3 lightBehind(const glm::vec3& kd, float alpha, bool isProposed)
    {
        const Scene scene = paneOf(kd, alpha);
        Features features;
        features.enableShading = features.enableShadows = features.enableTransparency = true;
        features.extra.enableProposedShadowFormula = isProposed;
        const BVH bvh(scene, features);
        RenderState state { scene, features, bvh, Sampler(1) };
        const Ray ray { { 0.0f, 0.5f, 0.0f }, { 0.0f, -1.0f, 0.0f }, 0.5f };
        const HitInfo hitInfo { .normal = { 0.0f, 1.0f, 0.0f } };
        return visibilityOfLightSampleTransparency(state, { 0.0f, 2.0f, 0.0f }, glm::vec3(1.0f), ray, hitInfo);
    }

    // PanesQuestion -> std::vector<glm::vec3>
    const worker::Probe panes("figures.light_behind_pane", [](worker::Call& call) {
        const auto question = call.input.read<PanesQuestion>();
        std::vector<glm::vec3> light;
        for (const float alpha : question.alphas)
            light.push_back(lightBehind(question.kd, alpha, question.isProposed));
        call.output << light;
    });

}
}
