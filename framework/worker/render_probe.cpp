// The probe that renders a scene file.
#include "bvh.h"
#include "render.h"
#include "screen.h"
#include "worker/load_request.h"
#include "worker/measure_pixel.h"
#include "worker/probe.h"
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <thread>

namespace worker {
namespace {

    // Reports the share of rows begun, ten times a second, while it lives.
    class ProgressReporter {
    public:
        ProgressReporter(const Screen& screen, const std::function<void(float)>& report)
            : m_thread([this, &screen, &report](const std::stop_token& stop) {
                const auto isStopped = [&] { return stop.stop_requested(); };
                std::mutex mutex;
                std::unique_lock lock(mutex);
                while (!m_wake.wait_for(lock, stop, std::chrono::milliseconds(100), isStopped))
                    report(static_cast<float>(screen.rowsStarted()) / static_cast<float>(screen.resolution().y));
            })
        {
        }

    private:
        std::condition_variable_any m_wake;
        std::jthread m_thread;
    };

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
        const auto [scene, config] = load(request);
        BVH bvh { scene, config.features };
        const accel::CountingBVH counting { bvh };
        const Trackball camera = cameraOf(config, request);
        Screen screen { config.size };

        std::optional<ProgressReporter> reporter;
        if (request.wantsProgress)
            reporter.emplace(screen, call.progress);
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
