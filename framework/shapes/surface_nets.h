#pragma once
#include "shapes/solid.h"
#include <framework/mesh.h>

namespace shapes {

// The surface of a solid as a closed mesh, in which each edge has two triangles and the triangles around each
// vertex form one fan: the piece of the surface that is met first on the way from inside along +x. Gaps that are
// narrower than a cell are filled. Texture coordinates are those of a picture laid over the bounding box, seen
// from -z.
//
// One vertex in each cell that the surface cuts, one quad across each edge: Gibson 1998, "Constrained Elastic
// Surface Nets", without the relaxation. The surface is followed from cell to cell: Bloomenthal 1988,
// "Polygonization of Implicit Surfaces".
[[nodiscard]] Mesh polygonise(const Solid& solid, const glm::vec3& inside, float cellSize);

}
