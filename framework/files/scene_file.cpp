#include "files/scene_file.h"
#include "files/default_material.h"
#include "files/error.h"
#include "files/feature_settings.h"
#include "files/obj.h"
#include "files/scene_lights.h"
#include "files/scene_meshes.h"
#include "files/unit_ball.h"
#include <cctype>
#include <stdexcept>

namespace files {
namespace {

    constexpr int maxSize = 32768; // pixels: more than any screen, and width * height fits an int
    constexpr Range openHalfTurn { 0.001f, 179.999f, "an angle between 0 and 180 degrees" };

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

    void readCamera(TableReader& top, CameraConfig& camera)
    {
        if (const TomlValue* value = top.find("camera")) {
            TableReader table(top.path(), *value);
            table.read("look_at", camera.lookAt);
            table.read("rotation", camera.rotation);
            table.read("distance", camera.distanceFromLookAt, notNegative);
            table.read("field_of_view", camera.fieldOfView, openHalfTurn);
            table.finish();
        }
    }

    void readFeature(const TableReader& table, const TomlEntry& entry, Features& features)
    {
        const auto set = [&](const auto& content) {
            if constexpr (std::is_constructible_v<FeatureValue, decltype(content)>)
                setFeatureValue(features, entry.key, content);
            else
                table.failFound(entry.value, "true, false, a count or a name");
        };
        try {
            std::visit(set, entry.value.content);
        } catch (const std::invalid_argument& error) {
            table.fail(entry.line, error.what());
        }
    }

    void readFeatures(TableReader& top, Features& features)
    {
        if (const TomlValue* value = top.find("features")) {
            const TableReader table(top.path(), *value);
            for (const TomlEntry& entry : table.entries())
                readFeature(table, entry, features);
        }
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

    SceneFile readSceneFile(const std::filesystem::path& path)
    {
        const TomlValue document = loadToml(path);
        TableReader top(path, document);
        SceneFile file;
        top.read("size", file.config.size, 1, maxSize);
        const Frame frame = readFrame(top);
        readCamera(top, file.config.camera);
        readFeatures(top, file.config.features);

        Textures textures(file.scene);
        for (TableReader& table : top.readTables("mesh"))
            readMesh(table, frame, file.scene, textures);
        for (TableReader& table : top.readTables("sphere"))
            file.scene.spheres.push_back(readSphere(table, frame));
        for (TableReader& table : top.readTables("light"))
            file.scene.lights.push_back(readLight(table, frame));
        top.finish();
        return file;
    }

    // The camera of a Config sees all of the unit ball.
    SceneFile readObjScene(const std::filesystem::path& path)
    {
        SceneFile file;
        loadObj(path, file.scene);
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
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    if (extension == ".toml")
        return readSceneFile(path);
    if (extension == ".obj")
        return readObjScene(path);
    throw Error(path, "found the extension \"" + extension + "\", expected a scene in .toml or a model in .obj");
}

}
