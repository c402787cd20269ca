#include "scene.h"
#include "files/obj.h"
#include "files/scene_file.h"
#include "files/unit_ball.h"
#include <array>
#include <stdexcept>

namespace {

// In the order of SceneType.
constexpr std::array<const char*, SceneType::Custom> sceneNames { "single_triangle", "cube", "cube_textured",
    "cornell_box", "cornell_box_transparency", "cornell_box_parallelogram_light", "monkey", "teapot", "dragon",
    "spheres" };

}

Scene loadScenePrebuilt(SceneType type, const std::filesystem::path& dataDir)
{
    const auto index = static_cast<std::size_t>(type);
    if (index >= sceneNames.size())
        throw std::invalid_argument("found a custom scene, expected one that the course has: load it from its file");
    Scene scene = files::loadSceneFile(dataDir / (std::string(sceneNames[index]) + ".toml")).scene;
    scene.type = type;
    return scene;
}

Scene loadSceneFromFile(const std::filesystem::path& path, const std::vector<Scene::SceneLight>& lights)
{
    Scene scene;
    files::loadObj(path, scene);
    files::fitIntoUnitBall(scene.meshes);
    scene.lights = lights;
    return scene;
}
