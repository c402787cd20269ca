#pragma once
#include "debug/recording.h"
#include "scene.h"
#include <span>
#include <string>

namespace grading {

// What a drawing is compared with.
struct Surroundings {
    std::span<const debug::Hit> hits; // of the path's rays
    std::span<const Scene::SceneLight> lights;
    std::span<const debug::Drawn> drawing; // that the shape is part of
    std::size_t numLightSamples = 0; // that the path's surfaces are lit by
};

// In words: where a shape is, such as "along the normal" or "at a surface"; empty for a box.
[[nodiscard]] std::string placeOf(const debug::Drawn& shape, const Surroundings& surroundings);

// And what else can be said of it, such as "0.2 long".
[[nodiscard]] std::string extentOf(const debug::Drawn& shape, const Surroundings& surroundings);

// What is said of rays from a surface that end at a light.
inline const std::string toALight = "to a light";

}
