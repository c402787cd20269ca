#pragma once
#include "grading/probes/numbered_texels.h"
#include <cmath>
#include <limits>

// What the probes of textures are asked.
namespace stress {

struct Lookup {
    glm::ivec2 size { 1 }; // few different ones: the worker keeps all images
    glm::vec2 texCoord { 0.0f };
};

// One channel where there are millions of texels.
[[nodiscard]] inline grading::NumberedTexels texelsOf(const glm::ivec2& size)
{
    return { size, { 17, 90, 200 }, size.x * size.y > 1'000'000 ? 1 : 3 };
}

// A lookup, and the one at the next float of one coordinate.
struct Step {
    Lookup lookup;
    int axis = 0;
};

struct StepColors {
    glm::vec3 at, next;
};

[[nodiscard]] inline Lookup next(const Step& step)
{
    Lookup lookup = step.lookup;
    lookup.texCoord[step.axis] = std::nextafter(lookup.texCoord[step.axis], std::numeric_limits<float>::infinity());
    return lookup;
}

}
