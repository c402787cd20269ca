#pragma once
#include "files/mtl.h"
#include "values/progress.h"
#include <filesystem>
#include <map>

namespace files {

// What an OBJ file and its MTL files hold, before any scene has it.
struct ObjFile {
    std::vector<MtlMaterial> materials;
    std::map<int, Mesh> meshes; // by index of material; -1: none. Their materials are still to be set
};

// Reads what loadObj says, but for the textures. Throws Error.
[[nodiscard]] ObjFile readObjFile(const std::filesystem::path& path, values::Progress& progress);

}
