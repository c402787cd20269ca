#pragma once
#include "files/obj_files.h"
#include "files/scene_frame.h"
#include "files/table_reader.h"
#include "files/textures.h"
#include <span>

namespace files {

// Reads those of kd, ks, shininess and transparency that are there.
void readReflectance(TableReader& table, Material& material);

// What the meshes of a scene take from elsewhere.
struct MeshSources {
    ObjFiles files; // those that are named
    Textures textures;
};

// The files that the tables of [[mesh]] name, once for each that does.
[[nodiscard]] std::vector<std::filesystem::path> namedFiles(std::span<TableReader> tables);

// Adds what a [[mesh]] describes to the scene. Throws Error.
void readMesh(TableReader& table, const Frame& frame, Scene& scene, MeshSources& sources);

}
