#include "shapes/makers.h"

namespace shapes {

Mesh makeTriangle()
{
    constexpr glm::vec3 normal { 0.0f, 0.0f, -1.0f };
    return {
        .vertices = {
            { { 1.0f, -0.8f, 0.0f }, normal, { 0.0f, 0.0f } },
            { { -1.0f, -0.8f, 0.0f }, normal, { 1.0f, 0.0f } },
            { { 0.0f, 0.9f, 0.0f }, normal, { 0.5f, 1.0f } },
        },
        .triangles = { { 0, 1, 2 } },
        .material = {},
    };
}

}
