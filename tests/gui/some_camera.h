#pragma once
#include <framework/trackball.h>
#include <glm/trigonometric.hpp>

// One that looks from nowhere special, and not along an axis.
inline Trackball someCamera()
{
    Trackball camera { glm::radians(50.0f), 3.0f, 1.6f };
    camera.setCamera({ 0.1f, -0.2f, 0.3f }, { 0.4f, -1.1f, 0.2f }, 3.0f);
    return camera;
}
