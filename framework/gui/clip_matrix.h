#pragma once
#include <framework/trackball.h>
#include <glm/mat4x4.hpp>

namespace gui {

// Distances from the camera's plane, greater than 0.
struct DepthRange {
    float nearest, farthest;
};

// What lies in a ball, as far as a camera sees it.
[[nodiscard]] DepthRange depthRange(const Trackball& camera, const glm::vec3& center, float radius);

// Takes a position relative to the camera's to the clip space of OpenGL, so that the point that the camera's ray
// through ndc meets appears at ndc.
[[nodiscard]] glm::mat4 clipMatrix(const Trackball& camera, DepthRange range);

}
