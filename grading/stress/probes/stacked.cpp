#include "grading/stress/probes/stacked.h"
#include "bvh.h"
#include "grading/stress/probes/answer_all.h"
#include "light.h"
#include "recursive.h"

namespace stress {
namespace {

    const worker::Probe visibility("stress.visibility", [](worker::Call& call) {
        answerAll<LightBehindStack>(call, [](const LightBehindStack& query) {
            const Scene scene = sceneOf(query.stack);
            const Features features { .enableShadows = true, .enableAccelStructure = true, .enableTransparency = true };
            const BVH bvh(scene, features);
            RenderState state { scene, features, bvh, Sampler(1) };
            AllSeen seen {};
            for (std::size_t i = 0; i < seen.size(); ++i) {
                const auto& [point, camera, light] = query.looks[i];
                Ray ray = rayIn(query.stack, camera, point);
                ray.direction *= 0.25f; // t counts in units of it
                ray.t *= 4.0f;
                HitInfo hit {};
                hit.normal = glm::normalize(query.stack.up);
                const glm::vec3 position = placeIn(query.stack, light);
                const glm::vec3 white { 1.0f };
                seen[i] = { visibilityOfLightSampleBinary(state, position, white, ray, hit) ? 1u : 0u,
                    visibilityOfLightSampleTransparency(state, position, white, ray, hit) };
            }
            return seen;
        });
    });

    const worker::Probe rays("stress.rays_in_stack", [](worker::Call& call) {
        answerAll<RaysInStack>(call, [](const RaysInStack& query) {
            Scene scene = sceneOf(query.stack);
            scene.lights.push_back(PointLight { glm::vec3(0.0f), glm::vec3(1.0f) });
            Features features { .enableReflections = true, .enableAccelStructure = true, .enableTransparency = true };
            features.extra.maxDepth = query.maxDepth;
            const BVH bvh(scene, features);
            RenderState state { scene, features, bvh, Sampler(1) };
            Colors colors {};
            for (std::size_t i = 0; i < colors.size(); ++i) {
                Ray ray = rayIn(query.stack, query.rays[i][0], query.rays[i][1]);
                ray.t = FLT_MAX;
                colors[i] = renderRay(state, ray);
            }
            return colors;
        });
    });

}
}
