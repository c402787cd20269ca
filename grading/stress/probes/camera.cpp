#include "grading/probes/empty_state.h"
#include "grading/stress/probes/answer_all.h"
#include "grading/stress/probes/cameras.h"
#include "render.h"

namespace stress {
namespace {

    const worker::Probe camera("stress.camera", [](worker::Call& call) {
        answerAll<CameraPoint>(call, [](const CameraPoint& query) {
            Trackball trackball(query.fieldOfView, query.distance, query.aspectRatio);
            trackball.setCamera(query.lookAt, query.rotation, query.distance);
            return trackball.generateRay(query.ndc);
        });
    });

    const worker::Probe pixelRays("stress.pixel_rays", [](worker::Call& call) {
        const grading::EmptyState empty;
        answerAll<PixelRays>(call, [&](const PixelRays& query) {
            Config config { .size = query.size };
            config.camera = { .rotation = glm::vec3(0.0f), .fieldOfView = query.fieldOfView };
            config.features.numPixelSamples = query.numSamples;
            RenderState state { empty.scene, config.features, empty.bvh, Sampler(query.seed) };
            const auto generate = query.isStratified ? generatePixelRaysStratified : generatePixelRaysUniform;
            const std::vector<Ray> rays = generate(state, makeTrackball(config), query.pixel, query.size);
            RaysOfPixel answer { static_cast<uint32_t>(rays.size()), {} };
            std::copy_n(rays.begin(), std::min(rays.size(), PixelRays::most), answer.rays.begin());
            return answer;
        });
    });

}
}
