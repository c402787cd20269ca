#pragma once
#include <glm/vec3.hpp>

namespace grading {

struct LightSample {
    glm::vec3 position, color;
};

}
