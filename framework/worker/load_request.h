#pragma once
#include "files/scene_file.h"
#include "worker/render_request.h"
#include <functional>

namespace worker {

// The scene file of a request, with the request's settings in place of its own; but the camera is the scene's. Tells
// how much of its meshes is read, in [0, 1], if the request wants to know. Throws files::Error, and
// std::invalid_argument for a setting that there is not.
[[nodiscard]] files::SceneFile load(const RenderRequest& request, const std::function<void(float)>& onProgress = {});

// Where the request looks from.
[[nodiscard]] Trackball cameraOf(Config config, const RenderRequest& request);

}
