#pragma once
#include "common.h"
#include <array>
#include <glm/vec2.hpp>
#include <vector>

namespace worker {

// What is sampled to see how far samples are from the truth, at several places each.
enum class Integrand : uint32_t {
    Edge, // pixels that an edge crosses at any angle
    AxisEdge, // pixels that an edge crosses along their rows or columns
    SoftShadow, // points below a light that is blocked in part
    Smooth, // points below a light that is not
};

// White triangles across the view, on black. One edge of each goes through a pixel of its own: through any point, and
// at any angle or along the pixel's sides, all alike. So pixels count by how much of an edge they hold. If instead all
// lines that meet a pixel were alike, those that cut a corner off counted more: the gain of stratified samples were
// exactly sqrt(N), 8 of 64 (a line meets sqrt(N) of its N cells, on average), and not 8.5; Owen's 11.2, and not 11.9.
struct EdgePicture {
    static constexpr int numTiles = 32; // a row; each has a triangle
    static constexpr int tileSide = 5; // pixels
    static constexpr int side = numTiles * tileSide;

    using Corners = std::array<glm::dvec2, 3>; // in pixels, counterclockwise
    std::vector<Corners> triangles;
    std::vector<glm::ivec2> pixels; // in which each has its edge: the places
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
