#pragma once
#include "shading.h"
#include <array>

// What the probe of gradients is asked.
namespace stress {

struct GradientQuery {
    std::array<LinearGradient::Component, 8> components {};
    uint32_t count = 0; // of them, the first
    float ti = 0.0f;
};

}
