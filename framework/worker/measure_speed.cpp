#include "worker/measure_speed.h"
#include "accel/recording_bvh.h"
#include "screen.h"
#include "values/needs_of.h"
#include "worker/library_bvh.h"
#include <chrono>
#include <tbb/global_control.h>
#include <tbb/info.h>

namespace worker {
namespace {

    // Whoever answers rays, over and over.
    struct Contestant {
        Timing& timing;
        std::function<void()> answer;
    };

    class Contest {
    public:
        Contest(const Scene& scene, const Config& config)
            : m_scene(scene)
            , m_config(config)
            , m_bvh(scene, config.features)
            , m_library(scene, config.features)
        {
            m_speed.numTriangles = m_bvh.numPrimitives();
            m_recorded = record(m_library);
            addFrame(m_speed.frame, m_library, m_recorded);
            addRays(
                m_speed.traversal,
                [tree = m_library.wideTree()](const Ray& ray) { return tree->closest(ray).has_value(); },
                [tree = m_library.wideTree()](const Ray& ray) { return tree->occluded(ray); });
            addHits(m_speed.hits, m_library);
            addHits(m_speed.theirHits, m_bvh);
            addFrame(m_speed.theirFrame, m_bvh, record(m_bvh));
            addThreadedFrames();
        }

        // Everybody has a turn, the first a later one each time.
        void run(uint32_t repetition)
        {
            for (std::size_t turn = 0; turn < m_contestants.size(); ++turn) {
                const Contestant& contestant = m_contestants[(turn + repetition) % m_contestants.size()];
                const tbb::global_control threads(
                    tbb::global_control::max_allowed_parallelism, contestant.timing.numThreads);
                const auto start = std::chrono::steady_clock::now();
                contestant.answer();
                const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
                contestant.timing.seconds.push_back(elapsed.count());
            }
        }

        [[nodiscard]] const Speed& speed() const { return m_speed; }

    private:
        void renderWith(const BVHInterface& bvh) { renderImage(m_scene, bvh, m_config.features, m_camera, m_screen); }

        // Also builds what is built when it is first asked for.
        accel::RecordedRays record(BVHInterface& bvh)
        {
            const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
            accel::RecordedRays recorded;
            renderWith(accel::RecordingBVH(bvh, recorded));
            return recorded;
        }

        void addFrame(Timing& timing, const BVHInterface& bvh, const accel::RecordedRays& recorded)
        {
            timing.numRays = recorded.numRays();
            timing.numHits = recorded.numHits;
            m_contestants.push_back({ timing, [this, &bvh] { renderWith(bvh); } });
        }

        // Whether the ray meets something, of which more may be asked, and of a shadow ray no more.
        template <typename Trace, typename TraceShadow>
        void addRays(Timing& timing, Trace trace, TraceShadow traceShadow)
        {
            timing.numRays = m_recorded.numRays();
            m_contestants.push_back({ timing, [this, &timing, trace, traceShadow]() mutable {
                                         timing.numHits = 0;
                                         for (const Ray& ray : m_recorded.rays)
                                             timing.numHits += trace(ray);
                                         for (const Ray& ray : m_recorded.shadowRays)
                                             timing.numHits += traceShadow(ray);
                                     } });
        }

        void addHits(Timing& timing, const BVHInterface& bvh)
        {
            const RenderState start { m_scene, m_config.features, bvh, Sampler(1),
                values::needsOf(m_scene, m_config.features) };
            addRays(
                timing,
                [state = start](Ray ray) mutable {
                    HitInfo hitInfo;
                    return state.bvh.intersect(state, ray, hitInfo);
                },
                [state = start](const Ray& ray) mutable { return state.bvh.isOccluded(state, ray); });
        }

        void addThreadedFrames()
        {
            const auto numCores = static_cast<uint32_t>(tbb::info::default_concurrency());
            for (const uint32_t numThreads : { 2u, numCores })
                if (numThreads <= numCores && (m_speed.threadedFrames.empty() || numThreads > 2))
                    m_speed.threadedFrames.push_back({ .numThreads = numThreads });
            for (Timing& timing : m_speed.threadedFrames)
                addFrame(timing, m_library, m_recorded);
        }

        const Scene& m_scene;
        const Config& m_config;
        const Trackball m_camera = makeTrackball(m_config);
        BVH m_bvh;
        LibraryBVH m_library;
        Screen m_screen { m_config.size };
        accel::RecordedRays m_recorded; // of the library's frame
        Speed m_speed;
        std::vector<Contestant> m_contestants;
    };

}

Speed measureSpeed(
    const Scene& scene, const Config& config, uint32_t numRepetitions, const std::function<void(float)>& progress)
{
    Contest contest { scene, config };
    for (uint32_t repetition = 0; repetition < numRepetitions; ++repetition) {
        progress(static_cast<float>(repetition) / static_cast<float>(numRepetitions));
        contest.run(repetition);
    }
    return contest.speed();
}

}
