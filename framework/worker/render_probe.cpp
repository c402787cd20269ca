// The probe that renders a scene file.
#include "accel/counting_bvh.h"
#include "bvh.h"
#include "files/feature_settings.h"
#include "files/scene_file.h"
#include "render.h"
#include "screen.h"
#include "worker/probe.h"
#include "worker/render_request.h"
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <tbb/global_control.h>
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

    // "name=value"
    void apply(const std::string& setting, Features& features)
    {
        const std::size_t equals = setting.find('=');
        if (equals == std::string::npos)
            throw std::invalid_argument("found the setting '" + setting + "', expected feature=value");
        files::setFeature(features, setting.substr(0, equals), setting.substr(equals + 1));
    }

    files::SceneFile load(const RenderRequest& request)
    {
        files::SceneFile file = files::loadSceneFile(request.scene);
        for (const std::string& setting : request.settings)
            apply(setting, file.config.features);
        if (request.size != glm::ivec2(0))
            file.config.size = request.size;
        return file;
    }

    // The whole picture, by the submission's own renderImage where it has one.
    const Probe image("render.image", [](Call& call) {
        const auto request = call.input.read<RenderRequest>();
        std::optional<tbb::global_control> threads;
        if (request.numThreads > 0)
            threads.emplace(tbb::global_control::max_allowed_parallelism, request.numThreads);
        const auto [scene, config] = load(request);
        BVH bvh { scene, config.features };
        const accel::CountingBVH counting { bvh };
        Screen screen { config.size };

        std::optional<ProgressReporter> reporter;
        if (request.wantsProgress)
            reporter.emplace(screen, call.progress);
        const uint64_t raysBefore = accel::CountingBVH::numRays();
        const auto start = std::chrono::steady_clock::now();
        renderImage(scene, counting, config.features, makeTrackball(config), screen);
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        reporter.reset();
        const uint64_t numRays = accel::CountingBVH::numRays() - raysBefore;
        call.output << Rendering { config.size, std::move(screen.pixels()), elapsed.count(), numRays };
    });

}
}
