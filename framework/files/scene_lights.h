#pragma once
#include "files/scene_frame.h"
#include "files/table_reader.h"
#include "scene.h"

namespace files {

// The light that a [[light]] describes. Throws Error.
[[nodiscard]] Scene::SceneLight readLight(TableReader& table, const Frame& frame);

}
