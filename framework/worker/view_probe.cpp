// The probes of a window that shows a scene.
#include "bvh.h"
#include "files/scene_file.h"
#include "values/resident_memory.h"
#include "worker/counted_work.h"
#include "worker/explain_needs.h"
#include "worker/follow_ray.h"
#include "worker/measure_pixel.h"
#include "worker/probe.h"
#include "worker/tree_drawing.h"
#include "worker/view.h"
#include <chrono>
#include <memory>
#include <optional>
#include <stdexcept>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace worker {
namespace {

    // The tree refers to the scene: both stay where they are.
    struct Opened {
        explicit Opened(const OpenRequest& request)
            : scene(files::loadSceneFile(request.scene).scene)
            , features { .extra = { .enableBvhSahBinning = request.enableBvhSahBinning } }
            , bvh(scene, features)
        {
            (void)bvh.wideTree(); // built now: a change of a setting must not wait for it
        }

        Scene scene;
        Features features;
        BVH bvh;
    };

    std::unique_ptr<Opened> opened;

    Opened& current()
    {
        if (!opened)
            throw std::logic_error("no scene is open");
        return *opened;
    }

    Opened& withLights(const std::vector<Scene::SceneLight>& lights)
    {
        current().scene.lights = lights;
        return *opened;
    }

    std::vector<glm::ivec2> pixelsOfPass(const RowsRequest& request, int rowsEnd)
    {
        std::vector<glm::ivec2> pixels;
        for (int y = request.firstRow; y < rowsEnd; y += request.stride)
            for (int x = 0; x < request.view.size.x; x += request.stride)
                if (isInPass(request.stride, x, y))
                    pixels.emplace_back(x, y);
        return pixels;
    }

    const Probe open("view.open", [](Call& call) {
        opened.reset(); // before the next one takes its memory
        opened = std::make_unique<Opened>(call.input.read<OpenRequest>());
    });

    const Probe rows("view.rows", [](Call& call) {
        auto request = call.input.read<RowsRequest>();
        Opened& now = withLights(request.view.lights);
        const accel::CountingBVH counting { now.bvh };
        const bool isSeen = request.view.quantity == debug::Quantity::Color; // measured is what is done for anything
        const SceneNeeds needs = isSeen ? values::needsOf(now.scene, request.view.features) : SceneNeeds();
        CountedWork work;
        const auto start = std::chrono::steady_clock::now();
        const std::chrono::duration<double> budget { request.seconds };
        const int rowsAtOnce = 2 * tbb::this_task_arena::max_concurrency() * request.stride;
        Rows answer { .end = request.firstRow };
        do {
            answer.end = std::min(request.firstRow + rowsAtOnce, request.view.size.y);
            const std::vector<glm::ivec2> pixels = pixelsOfPass(request, answer.end);
            const std::size_t first = answer.pixels.size();
            answer.pixels.resize(first + pixels.size());
            tbb::parallel_for(std::size_t(0), pixels.size(), [&](std::size_t i) {
                std::optional<CountedWork::Part> part;
                if (request.view.isCounted)
                    part.emplace(work);
                answer.pixels[first + i] = measurePixel(now.scene, counting, request.view, pixels[i], needs);
            });
            request.firstRow = answer.end;
        } while (answer.end < request.view.size.y && std::chrono::steady_clock::now() - start < budget);
        answer.work = work.sum();
        if (request.view.isCounted)
            answer.needs = explainNeeds(now.scene, request.view.features);
        answer.memory = values::residentMemory();
        call.output << answer;
    });

    const Probe follow("view.follow", [](Call& call) {
        const auto [view, pixel] = call.input.read<FollowRequest>();
        const Opened& now = withLights(view.lights);
        call.output << followRay(now.scene, view.features, now.bvh, view.camera, pixel, view.size);
    });

    const Probe tree("view.tree", [](Call& call) {
        constexpr std::size_t most = 4096; // shapes, that can be told apart and drawn in each frame
        const auto [level, leaf] = call.input.read<TreeRequest>();
        BVH& bvh = current().bvh;
        const debug::Recording recording { most };
        if (level >= 0)
            bvh.debugDrawLevel(level);
        if (leaf >= 1)
            bvh.debugDrawLeaf(leaf);
        call.output << TreeDrawing { bvh.numLevels(), bvh.numLeaves(), recording.shapes(), recording.numDropped() };
    });

}
}
