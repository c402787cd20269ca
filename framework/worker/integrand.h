#pragma once
#include "common.h"
#include <glm/vec2.hpp>
#include <vector>

namespace worker {

// What is sampled to see how far samples are from the truth, at several places each.
enum class Integrand : uint32_t {
    Edge, // pixels that a slanting edge crosses
    AxisEdge, // pixels that an edge crosses along their rows
    SoftShadow, // points below a light that is blocked in part
    Smooth, // points below a light that is not
};

// A white triangle across the view: where it is seen, a picture is 1.
struct EdgePicture {
    static constexpr int side = 16; // pixels

    std::vector<glm::dvec2> corners; // in pixels
    std::vector<glm::ivec2> pixels; // that an edge crosses: the places
};

[[nodiscard]] EdgePicture edgePicture(Integrand integrand);

// Points of a white floor, which faces up, below a white light; perhaps with a triangle between. So large that the
// distance that shadow rays keep from surfaces is nothing.
struct LitFloor {
    ParallelogramLight light;
    std::vector<glm::vec3> blocker; // three corners or none
    std::vector<glm::vec3> points; // the places
};

[[nodiscard]] LitFloor litFloor(Integrand integrand);

}
