#pragma once
#include "report/sheet.h"
#include "scene.h"
#include "worker/debug_ray.h"

namespace report {

// A lookup in the texture's own space: texels as cells, the place looked up as a cross, what took part outlined with
// its weight.
[[nodiscard]] Plot textureSpace(const std::string& label, const worker::TextureLookup& lookup, const Scene& scene);

// Where the texels that took part have their mean, by weight, from where the lookup was; in texels.
[[nodiscard]] float distanceOfMean(const worker::TextureLookup& lookup);

[[nodiscard]] float sumOfWeights(const worker::TextureLookup& lookup);

}
