#include "files/obj_fans.h"
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <span>
#include <sstream>
#include <tiny_obj_loader.h>

namespace files {
namespace {

    std::span<ObjTriangle> trianglesOf(ObjData& data, const ObjFan& fan)
    {
        return std::span(data.triangles).subspan(fan.firstTriangle, fan.numCorners - 2);
    }

    std::vector<ObjCorner> cornersOf(std::span<const ObjTriangle> triangles)
    {
        std::vector<ObjCorner> corners { triangles[0][0], triangles[0][1] };
        for (const ObjTriangle& triangle : triangles)
            corners.push_back(triangle[2]);
        return corners;
    }

    void cutQuad(const std::vector<glm::vec3>& positions, std::span<ObjTriangle> triangles)
    {
        const auto [a, b, c, d] = std::array { triangles[0][0], triangles[0][1], triangles[0][2], triangles[1][2] };
        const auto length = [&](const ObjCorner& from, const ObjCorner& to) { // squared
            const glm::vec3 way
                = positions[static_cast<std::size_t>(to.position)] - positions[static_cast<std::size_t>(from.position)];
            return glm::dot(way, way);
        };
        if (!(length(a, c) < length(b, d))) {
            triangles[0] = { a, b, d };
            triangles[1] = { b, c, d };
        }
    }

    // The polygon's triangles as indices into its corners.
    std::vector<tinyobj::index_t> cutOffEars(
        const std::vector<glm::vec3>& positions, const std::vector<ObjCorner>& corners)
    {
        std::string file, face = "f";
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const glm::vec3& p = positions[static_cast<std::size_t>(corners[i].position)];
            file += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
            face += fmt::format(" {}", i + 1);
        }
        std::istringstream stream(file + face + "\n");
        tinyobj::attrib_t unused;
        std::vector<tinyobj::shape_t> shapes;
        std::vector<tinyobj::material_t> none;
        (void)tinyobj::LoadObj(&unused, &shapes, &none, nullptr, nullptr, &stream);
        return shapes.empty() ? std::vector<tinyobj::index_t>() : shapes[0].mesh.indices;
    }

    void cutPolygon(const std::vector<glm::vec3>& positions, std::span<ObjTriangle> triangles)
    {
        const std::vector<ObjCorner> corners = cornersOf(triangles);
        const std::vector<tinyobj::index_t> cut = cutOffEars(positions, corners);
        if (cut.size() != 3 * triangles.size())
            return;
        for (std::size_t i = 0; i < cut.size(); ++i)
            triangles[i / 3][i % 3] = corners[static_cast<std::size_t>(cut[i].vertex_index)];
    }

}

void cutFans(ObjData& data)
{
    for (const ObjFan& fan : data.fans)
        if (fan.numCorners == 4)
            cutQuad(data.positions, trianglesOf(data, fan));
        else
            cutPolygon(data.positions, trianglesOf(data, fan));
}

}
