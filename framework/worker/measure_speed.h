#pragma once
#include "config.h"
#include "scene.h"
#include "worker/speed.h"
#include <functional>

namespace worker {

// How fast the config's picture of the scene is made, and its rays are answered. Tells how far it is, in [0, 1].
[[nodiscard]] Speed measureSpeed(
    const Scene& scene, const Config& config, uint32_t numRepetitions,
    const std::function<void(float)>& progress = [](float) {});

}
