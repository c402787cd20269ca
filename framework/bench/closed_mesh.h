#pragma once
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace bench {

// A dented ball around the origin, closed: every edge belongs to two triangles. Each level has four times the triangles
// of the one below, beginning with eight. Its middle sees all of it.
struct ClosedMesh {
    using Triangle = std::array<glm::vec3, 3>;

    explicit ClosedMesh(int level)
    {
        const glm::vec3 x { 1, 0, 0 }, y { 0, 1, 0 }, z { 0, 0, 1 };
        for (const float i : { -1.0f, 1.0f })
            for (const float j : { -1.0f, 1.0f })
                for (const float k : { -1.0f, 1.0f })
                    divide({ i * x, j * y, k * z }, level);
    }

    void move(float scale, const glm::vec3& by)
    {
        for (Triangle& triangle : triangles)
            for (glm::vec3& corner : triangle)
                corner = scale * (corner + by);
    }

    std::vector<Triangle> triangles;

private:
    void divide(const Triangle& t, int level)
    {
        if (level == 0) {
            triangles.push_back({ dented(t[0]), dented(t[1]), dented(t[2]) });
            return;
        }
        const glm::vec3 a = glm::normalize(t[1] + t[2]), b = glm::normalize(t[2] + t[0]),
                        c = glm::normalize(t[0] + t[1]);
        for (const Triangle& part : { Triangle { t[0], c, b }, { c, t[1], a }, { b, a, t[2] }, { a, b, c } })
            divide(part, level - 1);
    }

    // The same for all triangles that share the point.
    static glm::vec3 dented(const glm::vec3& p)
    {
        return p * (1.0f + 0.2f * std::sin(17.0f * p.x + 3.0f) * std::sin(13.0f * p.y) * std::cos(11.0f * p.z));
    }
};

}
