#pragma once
#include "debug/projection.h"
#include "debug/recording.h"

namespace debug {

// A drawn shape, or a part of it, as a camera's picture shows it.
struct Stroke {
    std::size_t shape = 0; // its index in the recording
    std::vector<glm::vec2> points; // in pixels, from the bottom left
    glm::vec3 color { 1.0f };
    float opacity = 1.0f;
    bool isFilled = false; // a convex area rather than a line
};

// In the order drawn. What lies behind the camera is left out.
[[nodiscard]] std::vector<Stroke> strokesOf(const std::vector<Shape>& shapes, const Projection& projection);

}
