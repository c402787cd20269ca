#pragma once
#include <framework/mesh.h>

namespace shapes {

[[nodiscard]] Mesh makeTriangle(); // one, in the plane z = 0
[[nodiscard]] Mesh makeCube(); // [-1, 1] on each axis; flat normals, the texture once on each face
[[nodiscard]] Mesh makeMonkey(); // a head of about 1,000 triangles
[[nodiscard]] Mesh makeTeapot(); // the Utah teapot in Newell's measures, about 15,000 triangles
[[nodiscard]] Mesh makeDragon(); // a serpent with legs, about 100,000 triangles

}
