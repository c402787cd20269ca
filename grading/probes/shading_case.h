#pragma once
#include <glm/vec3.hpp>

namespace grading {

// One point to be shaded.
struct ShadingCase {
    glm::vec3 cameraDirection, lightDirection, lightColor; // unit, unit, any
    glm::vec3 normal; // unit
    glm::vec3 kd { 0.5f }, ks { 1.0f };
    float shininess = 1.0f;
};

}
