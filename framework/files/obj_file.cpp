#include "files/obj_file.h"
#include "files/error.h"
#include "files/obj_data.h"
#include "files/obj_fans.h"
#include "files/obj_mesh.h"
#include "files/obj_syntax.h"
#include "files/polygons.h"
#include "files/smooth_normals.h"
#include "files/text.h"
#include <algorithm>
#include <iterator>
#include <set>
#include <tbb/parallel_invoke.h>

namespace files {
namespace {

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

    // For each of the names in use the index of the first material that has it; -1: there is none.
    std::vector<int> indicesOf(const std::vector<std::string>& names, const std::vector<MtlMaterial>& materials)
    {
        std::vector<int> indices;
        for (const std::string& name : names) {
            const auto found = std::ranges::find(materials, name, &MtlMaterial::name);
            indices.push_back(found == materials.end() ? -1 : static_cast<int>(found - materials.begin()));
        }
        return indices;
    }

    std::map<int, Mesh> makeMeshes(
        const ObjData& data, const std::vector<int>& materials, const std::vector<glm::vec3>& smoothNormals)
    {
        std::map<int, ObjMeshBuilder> builders;
        for (std::size_t i = 0; i < data.triangles.size(); ++i) {
            const int material = data.materials[i] < 0 ? -1 : materials[static_cast<std::size_t>(data.materials[i])];
            builders.try_emplace(material, data, smoothNormals).first->second.addTriangle(data.triangles[i]);
        }
        std::map<int, Mesh> meshes;
        for (auto& [material, builder] : builders)
            meshes.emplace(material, builder.take());
        return meshes;
    }

}

ObjFile readObjFile(const std::filesystem::path& path, values::Progress& progress)
{
    ObjOutline outline;
    ObjData data;
    tbb::parallel_invoke(
        [&] { outline = checkObjSyntax(path, readText(path), progress); }, [&] { data = parseObj(path); });
    if (outline.numTriangles == 0)
        throw Error(path, "found no faces, expected at least one");
    ObjFile file { loadMaterials(path, outline), {} };
    warnOfUnknownMaterials(path, outline, file.materials);

    checkFinite(path, data);
    cutFans(data);
    checkTriangulation(path, outline, data);
    file.meshes = makeMeshes(data, indicesOf(data.materialNames, file.materials), computeSmoothNormals(data));
    return file;
}

}
