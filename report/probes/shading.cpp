#include "shading.h"
#include "bvh.h"
#include "report/probes/shading_question.h"
#include "scene.h"
#include "worker/probe.h"

namespace report {
namespace {

    // A surface that looks along z, and somebody who looks at it.
    struct Stage {
        Scene scene;
        Features features;
        BVH bvh { scene, features };
        RenderState state { scene, features, bvh, Sampler(1) };

        [[nodiscard]] glm::vec3 shade(const ShadingQuestion& question)
        {
            features.enableShading = true;
            features.shadingModel = question.model;
            HitInfo hit {};
            hit.normal = { 0.0f, 0.0f, 1.0f };
            hit.material = { .kd = glm::vec3(0.0f), .ks = glm::vec3(1.0f), .shininess = question.shininess };
            return computeShading(state, question.toCamera, question.toLight, glm::vec3(1.0f), hit);
        }
    };

    // std::vector<ShadingQuestion> -> std::vector<glm::vec3>
    const worker::Probe colors("figures.shading", [](worker::Call& call) {
        Stage stage;
        std::vector<glm::vec3> answers;
        for (const ShadingQuestion& question : call.input.read<std::vector<ShadingQuestion>>())
            answers.push_back(stage.shade(question));
        call.output << answers;
    });

}
}
