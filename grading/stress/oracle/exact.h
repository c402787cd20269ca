#pragma once
#include "grading/probes/interpolation.h"
#include <framework/ray.h>
#include <optional>

namespace stress {

// Where the ray meets the triangle, edges included, at a distance in [0, ray.t], in rational numbers: nothing is
// rounded but the distance at the end. A triangle without area, or seen edge-on, is not met.
[[nodiscard]] std::optional<double> exactDistance(const grading::Triangle& triangle, const Ray& ray);

}
