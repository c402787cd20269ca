#include "files/obj.h"
#include "files/default_material.h"
#include "files/error.h"
#include "files/mtl.h"
#include "files/obj_data.h"
#include "files/obj_mesh.h"
#include "files/obj_syntax.h"
#include "files/polygons.h"
#include "files/smooth_normals.h"
#include "files/text.h"
#include "files/textures.h"
#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace files {
namespace {

    using Triangle = std::array<uint32_t, 3>; // indices of positions

    std::vector<MtlMaterial> loadMaterials(const std::filesystem::path& path, const ObjOutline& outline)
    {
        std::vector<MtlMaterial> materials;
        for (const NamedLine& library : outline.libraries) {
            const std::filesystem::path file = path.parent_path() / library.name;
            if (library.name.empty() || !std::filesystem::exists(file)) {
                warn(path, library.line, "found no \"" + library.name + "\", its materials are light grey");
                return {}; // then nor need the others define all names
            }
            std::ranges::move(loadMtl(file), std::back_inserter(materials));
        }
        return materials;
    }

    void warnOfUnknownMaterials(
        const std::filesystem::path& path, const ObjOutline& outline, const std::vector<MtlMaterial>& materials)
    {
        if (materials.empty())
            return;
        std::set<std::string> known;
        for (const MtlMaterial& material : materials)
            known.insert(material.name);
        for (const NamedLine& use : outline.materials)
            if (known.insert(use.name).second)
                warn(path, use.line, "found no material \"" + use.name + "\", it is light grey");
    }

    std::vector<std::string> namesOf(const std::vector<MtlMaterial>& materials)
    {
        std::vector<std::string> names;
        std::ranges::transform(materials, std::back_inserter(names), &MtlMaterial::name);
        return names;
    }

    std::vector<Triangle> positionTriangles(const ObjData& data)
    {
        const auto position = [](const ObjCorner& corner) { return static_cast<uint32_t>(corner.position); };
        std::vector<Triangle> triangles;
        triangles.reserve(data.triangles.size());
        for (const auto& [a, b, c] : data.triangles)
            triangles.push_back({ position(a), position(b), position(c) });
        return triangles;
    }

    // By index of material.
    std::map<int, Mesh> makeMeshes(const ObjData& data, const std::vector<glm::vec3>& smoothNormals)
    {
        std::map<int, ObjMeshBuilder> builders;
        for (std::size_t i = 0; i < data.triangles.size(); ++i)
            builders.try_emplace(data.materials[i], data, smoothNormals).first->second.addTriangle(data.triangles[i]);
        std::map<int, Mesh> meshes;
        for (auto& [material, builder] : builders)
            meshes.emplace(material, builder.take());
        return meshes;
    }

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

void loadObj(const std::filesystem::path& path, Scene& scene)
{
    Textures textures(scene);
    loadObj(path, scene, textures);
}

void loadObj(const std::filesystem::path& path, Scene& scene, Textures& textures)
{
    const ObjOutline outline = checkObjSyntax(path, readText(path));
    if (outline.numTriangles == 0)
        throw Error(path, "found no faces, expected at least one");
    const std::vector<MtlMaterial> materials = loadMaterials(path, outline);
    warnOfUnknownMaterials(path, outline, materials);

    const ObjData data = parseObj(path, namesOf(materials));
    const std::vector<Triangle> triangles = positionTriangles(data);
    checkTriangulation(path, outline, data.positions, triangles);
    for (auto& [index, mesh] : makeMeshes(data, computeSmoothNormals(data.positions, triangles))) {
        scene.meshes.push_back(std::move(mesh));
        scene.meshes.back().material
            = index < 0 ? defaultMaterial : finished(materials[static_cast<std::size_t>(index)], textures);
    }
}

}
