#pragma once
#include "config.h"
#include "scene.h"
#include <filesystem>

namespace files {

// Writes a scene file, a .toml, from which loadSceneFile reads this Config, these lights in world coordinates and all
// else that the original holds, a .toml or an .obj, to the last bit. It names the same models and pictures, relative
// to its own folder. Comments are not kept. The file appears whole or not at all, and may replace the original.
// Throws Error: the original cannot be read, the file cannot be written, or a value is one that no scene file may have.
void saveScene(const std::filesystem::path& to, const std::filesystem::path& original, const Config& config,
    const std::vector<Scene::SceneLight>& lights);

}
