// The probe that follows one ray.
#include "bvh.h"
#include "worker/follow_ray.h"
#include "worker/load_request.h"
#include "worker/probe.h"

namespace worker {

static const Probe ray("debug.ray", [](Call& call) {
    const auto request = call.input.read<DebugRayRequest>();
    const auto [scene, config] = load(request.render);
    const BVH bvh { scene, config.features };
    DebugRay followed = followRay(scene, config.features, bvh, makeTrackball(config), request.pixel, config.size);
    followed.camera = cameraOf(config, request.render);
    call.output << followed;
});

}
