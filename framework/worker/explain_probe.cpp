// The probe that tells what a picture needs, and what is done for it.
#include "bvh.h"
#include "recursive.h"
#include "render.h"
#include "values/needs_of.h"
#include "worker/counted_work.h"
#include "worker/explain_needs.h"
#include "worker/load_request.h"
#include "worker/probe.h"
#include <tbb/parallel_for.h>

namespace worker {
namespace {

    // Renders the picture for nothing but what is counted meanwhile.
    Work countWork(const Scene& scene, const Config& config, const Trackball& camera)
    {
        BVH bvh { scene, config.features };
        const accel::CountingBVH counting { bvh };
        const SceneNeeds needs = values::needsOf(scene, config.features);
        CountedWork work;
        tbb::parallel_for(0, config.size.y, [&](int y) {
            const CountedWork::Part part { work };
            for (int x = 0; x < config.size.x; ++x) {
                const auto index = static_cast<uint32_t>(y * config.size.x + x);
                RenderState state { scene, config.features, counting, Sampler(index), needs };
                (void)renderRays(state, generatePixelRays(state, camera, { x, y }, config.size));
            }
        });
        return work.sum();
    }

    Explanation explain(const RenderRequest& request, const std::function<void(float)>& progress)
    {
        const files::SceneFile file = load(request, progress);
        const Features& features = file.config.features;
        Explanation explanation { .skips = features.extra.enableSkipping, .parts = explainNeeds(file.scene, features) };
        explanation.work = countWork(file.scene, file.config, cameraOf(file.config, request));
        explanation.numTextures = static_cast<uint32_t>(file.scene.textures.size());
        for (const auto& texture : file.scene.textures)
            explanation.numDecoded += texture->pixels.areFetched();
        return explanation;
    }

    const Probe explainProbe(
        "render.explain", [](Call& call) { call.output << explain(call.input.read<RenderRequest>(), call.progress); });

}
}
