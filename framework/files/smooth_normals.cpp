#include "files/smooth_normals.h"
#include <glm/geometric.hpp>

namespace files {
namespace {

    std::size_t positionOf(const ObjCorner& corner)
    {
        return static_cast<std::size_t>(corner.position);
    }

}

glm::dvec3 areaNormal(const ObjData& data, const ObjTriangle& triangle)
{
    const glm::dvec3 p0 = data.positions[positionOf(triangle[0])];
    return glm::cross(glm::dvec3(data.positions[positionOf(triangle[1])]) - p0,
        glm::dvec3(data.positions[positionOf(triangle[2])]) - p0);
}

std::vector<glm::vec3> computeSmoothNormals(const ObjData& data)
{
    std::vector<glm::dvec3> sums(data.positions.size(), glm::dvec3(0.0));
    for (const ObjTriangle& triangle : data.triangles) {
        const glm::dvec3 normal = areaNormal(data, triangle);
        for (const ObjCorner& corner : triangle)
            sums[positionOf(corner)] += normal;
    }

    // Where the two sides of a sheet cancel, either is as good.
    for (const ObjTriangle& triangle : data.triangles)
        for (const ObjCorner& corner : triangle)
            if (sums[positionOf(corner)] == glm::dvec3(0.0))
                sums[positionOf(corner)] = areaNormal(data, triangle);

    std::vector<glm::vec3> normals;
    normals.reserve(data.positions.size());
    for (const glm::dvec3& sum : sums) { // no ray meets a triangle without area, but its normals are no NaN either
        const double length = glm::length(sum);
        normals.emplace_back(length > 0.0 ? sum / length : glm::dvec3(0.0, 1.0, 0.0));
    }
    return normals;
}

}
