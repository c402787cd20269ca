#pragma once
#include "config.h"
#include "grading/probes/pixel_case.h"
#include <array>

// What the probes of cameras and of pixel rays are asked, and answer.
namespace stress {

struct CameraPoint {
    float fieldOfView; // vertical, radians
    float aspectRatio;
    float distance;
    glm::vec3 lookAt, rotation; // radians
    glm::vec2 ndc;
};

struct PixelRays {
    static constexpr std::size_t most = 16;

    float fieldOfView; // degrees
    glm::ivec2 size;
    glm::ivec2 pixel;
    uint32_t seed;
    uint32_t numSamples; // most or fewer
    uint32_t isStratified;
};

struct RaysOfPixel {
    uint32_t count = 0; // of all; no more than most are here
    std::array<Ray, PixelRays::most> rays {};
};

}
