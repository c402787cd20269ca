#pragma once
#include "bvh_interface.h"
#include "grading/replicates.h"
#include "scene.h"
#include <framework/ray.h>
#include <functional>
#include <span>

namespace grading {

// A pixel's colour from its camera rays.
using Shade = std::function<glm::vec3(RenderState&, std::span<const Ray>)>;

// Renders the scene file once for each seed, with its tree built once.
[[nodiscard]] Replicates replicate(const ReplicatesRequest& request, const Shade& shade);

// The means of a picture's tiles of finestTile x finestTile. NaN where a pixel is.
[[nodiscard]] std::vector<glm::vec3> tileMeans(std::span<const glm::vec3> pixels, glm::ivec2 size);

}
