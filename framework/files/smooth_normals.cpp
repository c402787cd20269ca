#include "files/smooth_normals.h"
#include <glm/geometric.hpp>

namespace files {
namespace {

    // Twice the area long; in double, where no product of floats overflows.
    glm::dvec3 areaNormal(std::span<const glm::vec3> positions, const std::array<uint32_t, 3>& triangle)
    {
        const glm::dvec3 p0 = positions[triangle[0]];
        return glm::cross(glm::dvec3(positions[triangle[1]]) - p0, glm::dvec3(positions[triangle[2]]) - p0);
    }

}

std::vector<glm::vec3> computeSmoothNormals(
    std::span<const glm::vec3> positions, std::span<const std::array<uint32_t, 3>> triangles)
{
    std::vector<glm::dvec3> sums(positions.size(), glm::dvec3(0.0));
    for (const auto& triangle : triangles)
        for (const uint32_t corner : triangle)
            sums[corner] += areaNormal(positions, triangle);

    // Where the two sides of a sheet cancel, either is as good.
    for (const auto& triangle : triangles)
        for (const uint32_t corner : triangle)
            if (sums[corner] == glm::dvec3(0.0))
                sums[corner] = areaNormal(positions, triangle);

    std::vector<glm::vec3> normals;
    normals.reserve(positions.size());
    for (const glm::dvec3& sum : sums) { // no ray meets a triangle without area, but its normals are no NaN either
        const double length = glm::length(sum);
        normals.emplace_back(length > 0.0 ? sum / length : glm::dvec3(0.0, 1.0, 0.0));
    }
    return normals;
}

}
