// The probe that measures how fast a scene file is rendered.
#include "worker/load_request.h"
#include "worker/measure_speed.h"
#include "worker/probe.h"

namespace worker {
namespace {

    const Probe speed("render.speed", [](Call& call) {
        const auto request = call.input.read<SpeedRequest>();
        const auto [scene, config] = load(request.render);
        call.output << measureSpeed(scene, config, request.numRepetitions, call.progress);
    });

}
}
