// The probe that tells what a picture needs, and what is done for it.
#include "accel/counting_bvh.h"
#include "bvh.h"
#include "debug/cause.h"
#include "debug/tally.h"
#include "recursive.h"
#include "render.h"
#include "values/needs_of.h"
#include "worker/explanation.h"
#include "worker/load_request.h"
#include "worker/probe.h"
#include <atomic>
#include <tbb/parallel_for.h>

namespace worker {
namespace {

    // Renders the picture for nothing but what is counted meanwhile.
    void countWork(const Scene& scene, const Config& config, const Trackball& camera, Explanation& explanation)
    {
        BVH bvh { scene, config.features };
        const accel::CountingBVH counting { bvh };
        const SceneNeeds needs = values::needsOf(scene, config.features);
        const accel::RayCounts before = accel::CountingBVH::rayCounts();
        std::atomic<uint64_t> numNodes = 0, numTriangles = 0, numLookups = 0;
        tbb::parallel_for(0, config.size.y, [&](int y) {
            const debug::Watch watch; // rays to lights are told apart
            const debug::Tally tally;
            for (int x = 0; x < config.size.x; ++x) {
                const auto index = static_cast<uint32_t>(y * config.size.x + x);
                RenderState state { scene, config.features, counting, Sampler(index), needs };
                (void)renderRays(state, generatePixelRays(state, camera, { x, y }, config.size));
            }
            numNodes += tally.numNodes();
            numTriangles += tally.numTriangles();
            numLookups += tally.numLookups();
        });
        explanation.rays = accel::CountingBVH::rayCounts() - before;
        explanation.numNodes = numNodes;
        explanation.numTriangles = numTriangles;
        explanation.numLookups = numLookups;
    }

    Explanation explain(const RenderRequest& request, const std::function<void(float)>& progress)
    {
        const files::SceneFile file = load(request, progress);
        const Features& features = file.config.features;
        Explanation explanation { .skips = features.extra.enableSkipping };
        for (const values::Need& need : values::judgeNeeds(file.scene, features))
            explanation.parts.push_back({ need.part, need.why });
        countWork(file.scene, file.config, cameraOf(file.config, request), explanation);
        explanation.numTextures = static_cast<uint32_t>(file.scene.textures.size());
        for (const auto& texture : file.scene.textures)
            explanation.numDecoded += texture->pixels.areFetched();
        return explanation;
    }

    const Probe explainProbe(
        "render.explain", [](Call& call) { call.output << explain(call.input.read<RenderRequest>(), call.progress); });

}
}
