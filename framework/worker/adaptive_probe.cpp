// The probe that renders a scene file until it is good enough.
#include "accel/counting_bvh.h"
#include "bvh.h"
#include "values/stopwatch.h"
#include "worker/adaptive_request.h"
#include "worker/load_request.h"
#include "worker/probe.h"
#include <stdexcept>
#include <tbb/global_control.h>

namespace worker {
namespace {

    // What changes whole pictures has no error of single pixels.
    void checkPixelsAreAlone(const ExtraFeatures& extra)
    {
        const char* feature = extra.enableDepthOfField ? "depth_of_field"
            : extra.enableMotionBlur                   ? "motion_blur"
            : extra.enableBloomEffect                  ? "bloom"
                                                       : nullptr;
        if (feature)
            throw std::invalid_argument(std::string("found the feature ") + feature
                + ", expected none that renders whole pictures: --error and --time follow the rays of single pixels");
    }

    std::vector<glm::vec3> colorsOf(const adaptive::Picture& picture)
    {
        std::vector<glm::vec3> colors;
        colors.reserve(picture.estimates().size());
        for (const adaptive::Estimate& estimate : picture.estimates())
            colors.emplace_back(estimate.mean());
        return colors;
    }

    const Probe adaptiveImage("render.adaptive", [](Call& call) {
        const auto request = call.input.read<AdaptiveRequest>();
        std::optional<tbb::global_control> threads;
        if (request.render.numThreads > 0)
            threads.emplace(tbb::global_control::max_allowed_parallelism, request.render.numThreads);
        const auto [scene, config] = load(request.render, call.progress);
        checkPixelsAreAlone(config.features.extra);
        BVH bvh { scene, config.features };
        const accel::CountingBVH counting { bvh };
        const Trackball camera = cameraOf(config, request.render);
        const adaptive::PixelRays rays(scene, counting, config.features, camera, config.size, 0);

        const accel::RayCounts raysBefore = accel::CountingBVH::rayCounts();
        const values::Stopwatch watch;
        const adaptive::Picture picture = render(
            rays, config.size, request.goal, request.render.wantsProgress ? call.progress : [](float) {});
        const double seconds = watch.seconds();
        const uint64_t numRays = (accel::CountingBVH::rayCounts() - raysBefore).total();
        call.output << AdaptiveRendering { { config.size, colorsOf(picture), seconds, numRays }, summarize(picture) };
    });

}
}
