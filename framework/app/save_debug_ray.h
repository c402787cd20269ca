#pragma once
#include "worker/debug_ray.h"
#include <filesystem>

namespace app {

// Throws files::Error unless a debug ray can be saved under that name: .svg, .png, .exr or .json.
void checkDebugRayName(const std::filesystem::path& path);

// Writes what was drawn, over the picture of the scene or, as JSON, without it. Throws files::Error, PictureNotSaved.
void saveDebugRay(const std::filesystem::path& path, const worker::DebugRay& ray, const worker::Rendering& picture);

}
