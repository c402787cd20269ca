#include "shapes/makers.h"
#include <array>
#include <glm/geometric.hpp>

namespace shapes {
namespace {

    struct Face {
        glm::vec3 normal, up; // up is where v grows
    };

    constexpr std::array<Face, 6> faces { {
        { { 1, 0, 0 }, { 0, 1, 0 } },
        { { -1, 0, 0 }, { 0, 1, 0 } },
        { { 0, 1, 0 }, { 0, 0, 1 } },
        { { 0, -1, 0 }, { 0, 0, 1 } },
        { { 0, 0, 1 }, { 0, 1, 0 } },
        { { 0, 0, -1 }, { 0, 1, 0 } },
    } };

    // Four vertices of its own: the normals and texture coordinates of the faces differ at the corners they share.
    void addFace(Mesh& cube, const Face& face)
    {
        const auto first = static_cast<glm::uint>(cube.vertices.size());
        const glm::vec3 right = glm::cross(face.up, face.normal); // seen from outside, where u grows
        for (const glm::vec2 uv : { glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1) }) {
            const glm::vec3 onFace = (2.0f * uv.x - 1.0f) * right + (2.0f * uv.y - 1.0f) * face.up;
            cube.vertices.push_back({ face.normal + onFace, face.normal, uv });
        }
        cube.triangles.emplace_back(first, first + 1, first + 2);
        cube.triangles.emplace_back(first, first + 2, first + 3);
    }

}

Mesh makeCube()
{
    Mesh cube;
    for (const Face& face : faces)
        addFace(cube, face);
    return cube;
}

}
