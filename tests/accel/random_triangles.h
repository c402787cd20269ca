#pragma once
#include "accel/wide/tree.h"
#include "grading/random.h"

namespace tests {

inline std::vector<accel::WideTree::Triangle> randomTriangles(grading::Random& random, int count, float size)
{
    std::vector<accel::WideTree::Triangle> triangles;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 center = random.vec3(-1.0f, 1.0f);
        const auto corner = [&] { return center + size * random.vec3(-1.0f, 1.0f); };
        triangles.push_back({ corner(), corner(), corner() });
    }
    return triangles;
}

}
