// The probe that renders a scene file.
#include "bvh.h"
#include "render.h"
#include "screen.h"
#include "worker/load_request.h"
#include "worker/measure_pixel.h"
#include "worker/probe.h"
#include "worker/progress_reporter.h"
#include <chrono>
#include <optional>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

namespace worker {
namespace {

    void measureImage(const Scene& scene, const accel::CountingBVH& bvh, const View& view, Screen& screen)
    {
        tbb::parallel_for(0, view.size.y, [&](int y) {
            for (int x = 0; x < view.size.x; ++x)
                screen.setPixel(x, y, measurePixel(scene, bvh, view, { x, y }));
        });
    }

    // The whole picture; its colours are by the submission's own renderImage where it has one.
    const Probe image("render.image", [](Call& call) {
        const auto request = call.input.read<RenderRequest>();
        std::optional<tbb::global_control> threads;
        if (request.numThreads > 0)
            threads.emplace(tbb::global_control::max_allowed_parallelism, request.numThreads);
        const auto [scene, config] = load(request, call.progress);
        BVH bvh { scene, config.features };
        const accel::CountingBVH counting { bvh };
        const Trackball camera = cameraOf(config, request);
        Screen screen { config.size };

        std::optional<ProgressReporter> reporter;
        if (request.wantsProgress)
            reporter.emplace(
                [&screen] {
                    return static_cast<float>(screen.rowsStarted()) / static_cast<float>(screen.resolution().y);
                },
                call.progress);
        const accel::RayCounts raysBefore = accel::CountingBVH::rayCounts();
        const auto start = std::chrono::steady_clock::now();
        if (request.quantity == debug::Quantity::Color)
            renderImage(scene, counting, config.features, camera, screen);
        else
            measureImage(
                scene, counting, { camera, config.features, scene.lights, config.size, request.quantity }, screen);
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        reporter.reset();
        const uint64_t numRays = (accel::CountingBVH::rayCounts() - raysBefore).total();
        call.output << Rendering { config.size, std::move(screen.pixels()), elapsed.count(), numRays };
    });

}
}
