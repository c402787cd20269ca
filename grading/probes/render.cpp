#include "config.h"
#include "grading/probes/empty_state.h"
#include "grading/probes/pixel_case.h"
#include "grading/probes/render_replicate.h"
#include "recursive.h"
#include "worker/probe.h"

namespace grading {
namespace {

    using Generate = std::vector<Ray> (*)(RenderState&, const Trackball&, glm::ivec2, glm::ivec2);

    // configuration, pixels -> rays of each
    void generateAll(worker::Call& call, Generate generate)
    {
        const auto config = call.input.read<Config>();
        const Trackball camera = makeTrackball(config);
        const EmptyState empty;
        std::vector<std::vector<Ray>> rays;
        for (const PixelCase& c : call.input.read<std::vector<PixelCase>>()) {
            RenderState state { empty.scene, config.features, empty.bvh, Sampler(c.seed) };
            rays.push_back(generate(state, camera, c.pixel, config.size));
        }
        call.output << rays;
    }

    const worker::Probe uniform(
        "render.uniform", [](worker::Call& call) { generateAll(call, generatePixelRaysUniform); });
    const worker::Probe stratified(
        "render.stratified", [](worker::Call& call) { generateAll(call, generatePixelRaysStratified); });

    // A ReplicatesRequest -> Replicates. Whatever renderImage a submission has: it may choose seeds of its own.
    const worker::Probe picture("render.replicates", [](worker::Call& call) {
        call.output << replicate(call.input.read<ReplicatesRequest>(),
            [](RenderState& state, std::span<const Ray> rays) { return renderRays(state, rays); });
    });

}
}
