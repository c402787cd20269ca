#pragma once
#include "common.h"
#include <filesystem>
#include <memory>
#include <variant>
#include <vector>

enum SceneType {
    SingleTriangle,
    Cube,
    CubeTextured,
    CornellBox,
    CornellBoxTransparency,
    CornellBoxParallelogramLight,
    Monkey,
    Teapot,
    Dragon,
    Spheres,
    Custom,
};

struct Scene {
    using SceneLight = std::variant<PointLight, SegmentLight, ParallelogramLight>;

    SceneType type = SceneType::Custom;
    std::vector<Mesh> meshes;
    std::vector<Sphere> spheres;
    std::vector<SceneLight> lights;

    std::vector<std::shared_ptr<const Image>> textures; // what the materials' kdTexture point to
};

// One of the scenes of the course, not Custom: dataDir holds the scene files. Throws files::Error, and
// std::invalid_argument for Custom.
[[nodiscard]] Scene loadScenePrebuilt(SceneType type, const std::filesystem::path& dataDir);

// Any OBJ file, centred on the mean of its vertices and scaled by the largest distance from it. Throws files::Error.
[[nodiscard]] Scene loadSceneFromFile(const std::filesystem::path& path, const std::vector<Scene::SceneLight>& lights);
