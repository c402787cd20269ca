#include "files/polygons.h"
#include "files/error.h"
#include "files/smooth_normals.h"
#include <algorithm>
#include <glm/geometric.hpp>
#include <span>

namespace files {
namespace {

    // Whether the triangles have no corners but those of the polygon.
    bool belongTo(std::span<const ObjTriangle> triangles, const Polygon& polygon)
    {
        std::vector<uint32_t> corners = polygon.corners;
        std::ranges::sort(corners);
        return std::ranges::all_of(triangles, [&](const ObjTriangle& triangle) {
            return std::ranges::all_of(triangle, [&](const ObjCorner& corner) {
                return std::ranges::binary_search(corners, static_cast<uint32_t>(corner.position));
            });
        });
    }

    // Whether none of the triangles faces the other way: one that does lies outside of the polygon.
    bool faceOneWay(const ObjData& data, std::span<const ObjTriangle> triangles)
    {
        std::vector<glm::dvec3> areas;
        glm::dvec3 sum { 0.0 };
        for (const ObjTriangle& triangle : triangles) {
            areas.push_back(areaNormal(data, triangle));
            sum += areas.back();
        }
        // Corners of a flat polygon are rounded to 6 or 7 digits, by which a sliver may turn.
        const double tolerance = 1e-4 * glm::dot(sum, sum);
        return std::ranges::all_of(areas, [&](const glm::dvec3& area) { return glm::dot(area, sum) >= -tolerance; });
    }

}

void checkTriangulation(const std::filesystem::path& path, const ObjOutline& outline, const ObjData& data)
{
    const std::span<const ObjTriangle> triangles = data.triangles;
    for (const Polygon& polygon : outline.polygons) {
        const std::size_t expected = polygon.corners.size() - 2;
        const std::size_t left = triangles.size() - std::min(polygon.firstTriangle, triangles.size());
        const auto own = triangles.subspan(triangles.size() - left, std::min(expected, left));
        if (own.size() != expected || !belongTo(own, polygon) || !faceOneWay(data, own))
            throw Error(path, polygon.line,
                "found a face of " + std::to_string(polygon.corners.size())
                    + " corners that cannot be triangulated, expected a convex face or triangles");
    }
    if (triangles.size() != outline.numTriangles)
        throw Error(path,
            "found faces that make " + std::to_string(triangles.size()) + " triangles, expected "
                + std::to_string(outline.numTriangles));
}

}
