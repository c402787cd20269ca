// The probes that measure how fast a submission's own traversal is, on triangles that belong to no scene file.
#include "bvh.h"
#include "render.h"
#include "values/scene_of.h"
#include "values/stopwatch.h"
#include "worker/probe.h"
#include "worker/traversal.h"
#include <memory>
#include <stdexcept>

namespace worker {
namespace {

    // The tree may refer to the scene: both stay where they are.
    struct Built {
        explicit Built(const TraversalTriangles& triangles)
            : scene(values::sceneOf(triangles))
            , bvh(scene, features)
        {
        }

        Scene scene;
        Features features { .enableAccelStructure = true };
        BVH bvh;
    };

    std::unique_ptr<Built> built;

    const Probe build("traversal.build", [](Call& call) {
        const auto triangles = call.input.read<TraversalTriangles>();
        built.reset(); // before the next one takes its memory
        call.output << values::secondsOf([&] { built = std::make_unique<Built>(triangles); });
    });

    const Probe trace("traversal.trace", [](Call& call) {
        const auto rays = call.input.read<TraversalRays>();
        if (!built)
            throw std::logic_error("no tree is built");
        RenderState state { built->scene, built->features, built->bvh, Sampler(1) };
        TraversalAnswer answer;
        answer.distances.reserve(rays.size());
        answer.seconds = values::secondsOf([&] {
            for (Ray ray : rays) {
                HitInfo hitInfo;
                const bool isHit = built->bvh.intersect(state, ray, hitInfo);
                answer.distances.push_back(isHit ? ray.t : std::numeric_limits<float>::infinity());
            }
        });
        call.output << answer;
    });

}
}
