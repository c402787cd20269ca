#include "gui/orbit.h"

namespace gui {

void turn(CameraConfig& camera, glm::vec2 dragged)
{
    constexpr float halfTurn = 180.0f;
    camera.rotation.x = std::remainder(camera.rotation.x + dragged.y * halfTurn, 360.0f);
    camera.rotation.y = std::remainder(camera.rotation.y - dragged.x * halfTurn, 360.0f);
}

void pan(CameraConfig& camera, glm::vec2 dragged)
{
    const Trackball trackball = makeTrackball({ .camera = camera });
    const float height = 2.0f * camera.distanceFromLookAt * std::tan(glm::radians(camera.fieldOfView) / 2.0f);
    camera.lookAt += height * (dragged.x * trackball.left() + dragged.y * trackball.up());
}

void zoom(CameraConfig& camera, float steps)
{
    constexpr float nearest = 1e-3f, farthest = 1e4f;
    camera.distanceFromLookAt = std::clamp(camera.distanceFromLookAt * std::pow(0.9f, steps), nearest, farthest);
}

}
