#pragma once
#include "worker/message.h"
#include <cstdint>
#include <glm/vec2.hpp>

namespace report {

// What the probe figures.pixel_samples is asked for: where the rays of a picture's pixels go through it. The answer has
// for each pixel, row by row from the bottom, the places in pixels from the bottom left of the picture.
struct PixelQuestion {
    glm::ivec2 size { 1 }; // of the picture
    uint32_t numSamples = 1; // rays a pixel
    bool isStratified = false;
    uint32_t seed = 0; // pictures of different seeds have no random number in common
};

using PixelSamples = std::vector<std::vector<glm::vec2>>;

}
