#pragma once
#include "files/scene_file.h"
#include "worker/render_request.h"

namespace worker {

// The scene file of a request, with the request's settings in place of its own; but the camera is the scene's. Throws
// files::Error, and std::invalid_argument for a setting that there is not.
[[nodiscard]] files::SceneFile load(const RenderRequest& request);

// Where the request looks from.
[[nodiscard]] Trackball cameraOf(Config config, const RenderRequest& request);

}
