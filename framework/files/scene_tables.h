#pragma once
#include "config.h"
#include "files/toml_document.h"
#include "scene.h"

namespace files {

// What readCamera reads as this camera.
[[nodiscard]] TomlEntry cameraEntry(const CameraConfig& camera);

// What readConfig reads as this Config: size, camera and features.
[[nodiscard]] TomlValue::Table configTables(const Config& config);

// The [[light]] tables that readLight reads as these lights, in a scene file with or without a frame.
[[nodiscard]] TomlEntry lightTables(const std::vector<Scene::SceneLight>& lights, bool hasFrame);

}
