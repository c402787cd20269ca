#pragma once
#include <cstdint>
#include <glm/vec2.hpp>

namespace grading {

// One pixel that rays are to be generated for, and the seed of its random numbers.
struct PixelCase {
    glm::ivec2 pixel;
    uint32_t seed;
};

}
