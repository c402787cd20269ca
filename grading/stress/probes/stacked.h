#pragma once
#include "grading/stress/probes/stack.h"

// What the probes of visibility and of recursion are asked.
namespace stress {

// From a place on the pane or plane at height 0, seen from another place, to a light.
struct Look {
    glm::vec3 point, camera, light;
};

// Whether lights are visible through panes.
struct LightBehindStack {
    Stack stack;
    std::array<Look, 16> looks {};
};

struct Seen {
    uint32_t isVisible; // with opaque panes
    glm::vec3 left; // of white light, with transparent ones
};

using AllSeen = std::array<Seen, 16>;

// Rays that panes mirror and let through. A hit has the colour kd.
struct RaysInStack {
    Stack stack;
    uint32_t maxDepth = 6;
    std::array<std::array<glm::vec3, 2>, 16> rays {}; // from, to
};

using Colors = std::array<glm::vec3, 16>;

}
