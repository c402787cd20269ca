// The probe that tells what skipping is worth.
#include "render.h"
#include "screen.h"
#include "values/stopwatch.h"
#include "worker/library_bvh.h"
#include "worker/load_request.h"
#include "worker/probe.h"
#include "worker/skip_times.h"
#include "worker/specialised.h"
#include "worker/speed.h"
#include <tbb/global_control.h>

namespace worker {
namespace {

    struct Contestant {
        std::vector<double>& seconds;
        std::function<void(Screen&)> render;
        Screen screen;
    };

    float farthestOf(const Screen& a, const Screen& b)
    {
        float farthest = 0.0f;
        for (std::size_t i = 0; i < a.pixels().size(); ++i) {
            const glm::vec3 apart = glm::abs(a.pixels()[i] - b.pixels()[i]);
            farthest = std::max({ farthest, apart.x, apart.y, apart.z });
        }
        return farthest;
    }

    SkipTimes measureSkipping(const files::SceneFile& file, uint32_t numRepetitions, const Call& call)
    {
        const Scene& scene = file.scene;
        const Config& config = file.config;
        Features skipping = config.features, without = config.features;
        skipping.extra.enableSkipping = true;
        without.extra.enableSkipping = false;
        const LibraryBVH bvh { scene, skipping };
        const Trackball camera = makeTrackball(config);
        SkipTimes times;
        std::array<Contestant, 3> all { {
            { times.skipping, [&](Screen& s) { renderImage(scene, bvh, skipping, camera, s); }, Screen(config.size) },
            { times.without, [&](Screen& s) { renderImage(scene, bvh, without, camera, s); }, Screen(config.size) },
            { times.specialised, [&](Screen& s) { renderSpecialised(scene, bvh, skipping, camera, s); },
                Screen(config.size) },
        } };
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        for (Contestant& contestant : all) // builds what is built when it is first asked for
            contestant.render(contestant.screen);
        times.isSame = all[0].screen.pixels() == all[1].screen.pixels();
        times.farthest = farthestOf(all[0].screen, all[2].screen);
        for (uint32_t repetition = 0; repetition < numRepetitions; ++repetition) {
            call.progress(static_cast<float>(repetition) / static_cast<float>(numRepetitions));
            for (std::size_t turn = 0; turn < all.size(); ++turn) {
                Contestant& contestant = all[(turn + repetition) % all.size()];
                contestant.seconds.push_back(values::secondsOf([&] { contestant.render(contestant.screen); }));
            }
        }
        return times;
    }

    const Probe skip("render.skip", [](Call& call) {
        const auto request = call.input.read<SpeedRequest>();
        call.output << measureSkipping(load(request.render), request.numRepetitions, call);
    });

}
}
