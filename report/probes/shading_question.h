#pragma once
#include "common.h"

namespace report {

// What the probe figures.shading is asked for: the colour of a surface with normal (0, 0, 1), ks white and kd black, by
// white light.
struct ShadingQuestion {
    ShadingModel model = ShadingModel::LinearGradient;
    glm::vec3 toLight { 0.0f, 0.0f, 1.0f }; // unit
    glm::vec3 toCamera { 0.0f, 0.0f, 1.0f }; // unit
    float shininess = 1.0f;
};

}
