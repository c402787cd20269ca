#pragma once
#include "config.h"
#include "files/table_reader.h"

namespace files {

// The size, [camera] and [features] of a scene file. Throws Error.
[[nodiscard]] Config readConfig(TableReader& top);

// The [camera] alone; where there is none it stays as it is. Throws Error.
void readCamera(TableReader& top, CameraConfig& camera);

}
