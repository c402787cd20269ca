#include "shapes/bezier_patch.h"
#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>

namespace shapes {
namespace {

    using Weights = std::array<float, 4>;

    // The Bernstein polynomials of degree 3.
    Weights bernstein(float t)
    {
        const float s = 1.0f - t;
        return { s * s * s, 3.0f * s * s * t, 3.0f * s * t * t, t * t * t };
    }

    Weights bernsteinDerivative(float t)
    {
        const float s = 1.0f - t;
        return { -3.0f * s * s, 3.0f * s * (s - 2.0f * t), 3.0f * t * (2.0f * s - t), 3.0f * t * t };
    }

    glm::vec3 weighedSum(const BezierPatch& patch, const Weights& byU, const Weights& byV)
    {
        glm::vec3 sum { 0.0f };
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < 4; ++j)
                sum += byV[i] * byU[j] * patch.rows[i][j];
        }
        return sum;
    }

}

bool BezierPatch::collapsesAt(float v) const
{
    const auto& row = v == 0.0f ? rows.front() : rows.back();
    return (v == 0.0f || v == 1.0f) && std::ranges::count(row, row.front()) == 4;
}

glm::vec3 BezierPatch::position(float u, float v) const
{
    return weighedSum(*this, bernstein(u), bernstein(v));
}

glm::vec3 BezierPatch::normal(float u, float v) const
{
    const glm::vec3 alongV = weighedSum(*this, bernstein(u), bernsteinDerivative(v));
    glm::vec3 alongU = weighedSum(*this, bernsteinDerivative(u), bernstein(v));
    // Where the patch collapses the derivative by u is 0. Next to it, at v + dv, it is dv times the mixed derivative:
    // its direction is that one's, with the sign of the step that stays in the patch.
    if (collapsesAt(v))
        alongU = (1.0f - 2.0f * v) * weighedSum(*this, bernsteinDerivative(u), bernsteinDerivative(v));
    return glm::normalize(glm::cross(alongU, alongV));
}

}
