#pragma once
#include "files/obj_data.h"
#include "files/obj_syntax.h"

namespace files {

// Throws Error unless the triangles cover all faces. tinyobj drops
// what remains of a polygon when it finds no more ears, and takes corners of concave ones for ears that are none.
void checkTriangulation(const std::filesystem::path& path, const ObjOutline& outline, const ObjData& data);

}
