#pragma once
#include "scene.h"

namespace gui {

// A sphere as triangles, with its own normals.
[[nodiscard]] Mesh tessellate(const Sphere& sphere);

}
