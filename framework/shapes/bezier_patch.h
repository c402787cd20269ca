#pragma once
#include <array>
#include <glm/vec3.hpp>

namespace shapes {

// A bicubic Bezier patch. Row i of the control points weighs B_i(v), column j weighs B_j(u). Farin 2002, "Curves and
// Surfaces for CAGD", chapter 14.
struct BezierPatch {
    std::array<std::array<glm::vec3, 4>, 4> rows;

    // Whether all of the patch at v, 0 or 1, is one point.
    [[nodiscard]] bool collapsesAt(float v) const;

    [[nodiscard]] glm::vec3 position(float u, float v) const;

    // Unit, along the derivative by u cross that by v; also where the patch collapses.
    [[nodiscard]] glm::vec3 normal(float u, float v) const;
};

}
