#include "bvh.h"
#include "grading/stress/probes/answer_all.h"
#include "grading/stress/probes/rays.h"

namespace stress {
namespace {

    Scene sceneOf(const Soup& soup)
    {
        Scene scene;
        for (const auto& [v0, v1, v2] : soup.triangles) {
            const glm::vec3 normal { 0.0f, 1.0f, 0.0f };
            Mesh mesh { { { v0, normal, {} }, { v1, normal, {} }, { v2, normal, {} } }, { { 0, 1, 2 } }, {} };
            mesh.material.kd.x = static_cast<float>(scene.meshes.size());
            scene.meshes.push_back(std::move(mesh));
        }
        return scene;
    }

    using Intersect = bool (*)(RenderState&, const BVH&, Ray&, HitInfo&);

    void trace(worker::Call& call, Intersect intersect)
    {
        answerAll<Soup>(call, [&](const Soup& soup) {
            const Scene scene = sceneOf(soup);
            const Features features { .enableAccelStructure = true };
            const BVH bvh(scene, features);
            RenderState state { scene, features, bvh, Sampler(1) };
            std::vector<MetInSoup> all;
            all.reserve(soup.rays.size());
            for (Ray ray : soup.rays) {
                HitInfo hit {};
                const bool isHit = intersect(state, bvh, ray, hit);
                all.push_back({ { isHit, ray.t, hit.normal }, hit.material.kd.x, hit.barycentricCoord });
            }
            return all;
        });
    }

    const worker::Probe submission("stress.bvh", [](worker::Call& call) {
        trace(call, [](RenderState& state, const BVH& bvh, Ray& ray, HitInfo& hitInfo) {
            return bvh.intersect(state, ray, hitInfo);
        });
    });
    const worker::Probe library("stress.library", [](worker::Call& call) {
        trace(call, [](RenderState& state, const BVH& bvh, Ray& ray, HitInfo& hitInfo) {
            return intersectRayWithBVH(state, bvh, ray, hitInfo);
        });
    });

}
}
