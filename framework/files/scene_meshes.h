#pragma once
#include "files/scene_frame.h"
#include "files/table_reader.h"
#include "files/textures.h"

namespace files {

// Reads those of kd, ks, shininess and transparency that are there.
void readReflectance(TableReader& table, Material& material);

// Adds what a [[mesh]] describes to the scene. Throws Error.
void readMesh(TableReader& table, const Frame& frame, Scene& scene, Textures& textures);

}
