#pragma once
#include "config.h"
#include "scene.h"
#include "values/progress.h"
#include <filesystem>

namespace files {

struct SceneFile {
    Scene scene;
    Config config;
};

// Reads a scene: a .toml file as scenes/README.md describes it, or an .obj file, which is centred, scaled to the unit
// ball and lit by one point light. Throws Error.
[[nodiscard]] SceneFile loadSceneFile(const std::filesystem::path& path);
[[nodiscard]] SceneFile loadSceneFile(const std::filesystem::path& path, values::Progress& progress);

}
