#include "files/obj.h"
#include "files/default_material.h"
#include "files/error.h"
#include "files/obj_file.h"
#include "files/textures.h"

namespace files {
namespace {

    Material finished(const MtlMaterial& source, Textures& textures)
    {
        Material material = source.material;
        if (source.texture.empty())
            return material;
        try {
            material.kdTexture = textures.load(source.texture);
        } catch (const Error& error) {
            throw Error(source.file, source.textureLine, std::string("map_Kd: ") + error.what());
        }
        return material;
    }

}

void addObj(ObjFile file, Scene& scene, Textures& textures)
{
    for (auto& [index, mesh] : file.meshes) {
        scene.meshes.push_back(std::move(mesh));
        scene.meshes.back().material
            = index < 0 ? defaultMaterial : finished(file.materials[static_cast<std::size_t>(index)], textures);
    }
}

void loadObj(const std::filesystem::path& path, Scene& scene, values::Progress& progress)
{
    Textures textures(scene);
    addObj(readObjFile(path, progress), scene, textures);
}

void loadObj(const std::filesystem::path& path, Scene& scene)
{
    values::Progress nobodyLooks;
    loadObj(path, scene, nobodyLooks);
}

}
