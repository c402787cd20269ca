#pragma once
#include "common.h"
#include <framework/trackball.h>

// What a scene file says beside the scene itself: where to look from, what to switch on, how large.
struct CameraConfig {
    glm::vec3 lookAt { 0.0f };
    glm::vec3 rotation { 20.0f, 20.0f, 0.0f }; // degrees about x, y, z
    float distanceFromLookAt = 3.0f;
    float fieldOfView = 50.0f; // vertical, degrees
};

struct Config {
    CameraConfig camera;
    Features features;
    glm::ivec2 size { 800, 800 }; // pixels
};

[[nodiscard]] Trackball makeTrackball(const Config& config);
