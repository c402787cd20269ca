#include "files/scene_file.h"
#include "files/default_material.h"
#include "files/error.h"
#include "files/obj.h"
#include "files/scene_config.h"
#include "files/scene_lights.h"
#include "files/scene_meshes.h"
#include "files/text.h"
#include "files/unit_ball.h"

namespace files {
namespace {

    Frame readFrame(TableReader& top)
    {
        Frame frame;
        if (const TomlValue* value = top.find("frame")) {
            TableReader table(top.path(), *value);
            table.read("origin", frame.origin);
            table.read("unit", frame.unit, positive);
            table.finish();
        }
        return frame;
    }

    Sphere readSphere(TableReader& table, const Frame& frame)
    {
        Sphere sphere { .material = defaultMaterial };
        table.require("center", sphere.center);
        table.require("radius", sphere.radius, positive);
        readReflectance(table, sphere.material);
        table.finish();
        return { frame.point(sphere.center), frame.length(sphere.radius), sphere.material };
    }

    SceneFile readSceneFile(const std::filesystem::path& path, values::Progress& progress)
    {
        const TomlValue document = loadToml(path);
        TableReader top(path, document);
        SceneFile file;
        file.config = readConfig(top);
        const Frame frame = readFrame(top);

        std::vector<TableReader> meshes = top.readTables("mesh");
        MeshSources sources { ObjFiles(namedFiles(meshes), progress), Textures(file.scene) };
        for (TableReader& table : meshes)
            readMesh(table, frame, file.scene, sources);
        for (TableReader& table : top.readTables("sphere"))
            file.scene.spheres.push_back(readSphere(table, frame));
        for (TableReader& table : top.readTables("light"))
            file.scene.lights.push_back(readLight(table, frame));
        top.finish();
        return file;
    }

    // The camera of a Config sees all of the unit ball.
    SceneFile readObjScene(const std::filesystem::path& path, values::Progress& progress)
    {
        SceneFile file;
        loadObj(path, file.scene, progress);
        fitIntoUnitBall(file.scene.meshes);
        // On the side of the default camera, above.
        file.scene.lights.emplace_back(PointLight { { -1.0f, 1.0f, -1.0f }, glm::vec3(1.0f) });
        Features& features = file.config.features;
        features.enableShading = features.enableShadows = true;
        features.enableNormalInterp = features.enableTextureMapping = features.enableAccelStructure = true;
        return file;
    }

}

SceneFile loadSceneFile(const std::filesystem::path& path)
{
    values::Progress nobodyLooks;
    return loadSceneFile(path, nobodyLooks);
}

SceneFile loadSceneFile(const std::filesystem::path& path, values::Progress& progress)
{
    const std::string extension = lowerExtension(path);
    if (extension == ".toml")
        return readSceneFile(path, progress);
    if (extension == ".obj")
        return readObjScene(path, progress);
    throw Error(path, "found the extension \"" + extension + "\", expected a scene in .toml or a model in .obj");
}

}
