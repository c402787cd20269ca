#pragma once
#include "files/obj_data.h"

namespace files {

// Across a triangle, twice its area long; in double, where no product of floats overflows.
[[nodiscard]] glm::dvec3 areaNormal(const ObjData& data, const ObjTriangle& triangle);

// A unit normal for each position: the mean of those of the triangles around it, weighted by their areas.
[[nodiscard]] std::vector<glm::vec3> computeSmoothNormals(const ObjData& data);

}
