// The framework's debug.ray for scenes that are named from the root of the sources: so a question is the same, and its
// answer can be kept, wherever these lie.
#include "submission/paths.h"
#include "worker/debug_ray.h"
#include "worker/probe.h"
#include <filesystem>

namespace grading {

static const worker::Probe debugRay("render.debug_ray", [](worker::Call& call) {
    auto request = call.input.read<worker::DebugRayRequest>();
    request.render.scene = std::filesystem::path(submission::sourceDirectory) / request.render.scene;
    worker::Message input;
    input << request;
    worker::Reader reader { input };
    worker::Call inner { reader, call.output, call.progress };
    worker::Probe::find("debug.ray")(inner);
});

}
