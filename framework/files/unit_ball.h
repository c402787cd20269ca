#pragma once
#include <framework/mesh.h>
#include <span>

namespace files {

// Moves the mean of all vertices to the origin and scales by the largest distance from it.
void fitIntoUnitBall(std::span<Mesh> meshes);

}
