#pragma once
#include <filesystem>
#include <framework/mesh.h>
#include <string>
#include <vector>

namespace files {

// A material of an MTL file; its texture isn't loaded, since nobody may use it.
struct MtlMaterial {
    std::string name;
    Material material;
    std::filesystem::path texture; // empty without map_Kd
    std::filesystem::path file;
    int textureLine = 0;
};

// Kd, Ks, Ns, d (or 1 - Tr) and map_Kd of each material. Throws Error.
[[nodiscard]] std::vector<MtlMaterial> loadMtl(const std::filesystem::path& path);

}
