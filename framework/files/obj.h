#pragma once
#include "files/obj_file.h"
#include "scene.h"

namespace files {

class Textures;

// Adds the meshes of an OBJ file to the scene, one for each material in use, and the textures that these name.
// Polygons are triangulated, missing normals computed from the faces around a vertex. From the MTL file come Kd, Ks,
// Ns, d (or 1 - Tr) and map_Kd; texture paths are relative to the MTL file.
//
// Throws Error: no file, no faces, an index out of range, a number that is not finite, a polygon that tinyobj cannot
// triangulate, a missing texture. A missing MTL file is a warning on stderr, and so is a material that it doesn't
// define: models travel without them, and their shapes can be seen in light grey. A picture that an MTL file names,
// in contrast, should stand beside it: without it the scene is not the one that was meant.
void loadObj(const std::filesystem::path& path, Scene& scene);
void loadObj(const std::filesystem::path& path, Scene& scene, values::Progress& progress);

// The same of a file that is read already, with textures that the scene shares with other files. Throws Error.
void addObj(ObjFile file, Scene& scene, Textures& textures);

}
