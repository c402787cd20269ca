#include "config.h"

Trackball makeTrackball(const Config& config)
{
    const float aspectRatio = static_cast<float>(config.size.x) / static_cast<float>(config.size.y);
    Trackball camera { glm::radians(config.camera.fieldOfView), config.camera.distanceFromLookAt, aspectRatio };
    camera.setCamera(config.camera.lookAt, glm::radians(config.camera.rotation), config.camera.distanceFromLookAt);
    return camera;
}
