#pragma once
#include <array>
#include <cstddef>
#include <framework/mesh.h>
#include <glm/geometric.hpp>
#include <map>
#include <vector>

// What the tests measure on a mesh, in double precision.
namespace measures {

using Edge = std::array<std::size_t, 2>; // from one vertex to another

inline std::array<glm::dvec3, 3> corners(const Mesh& mesh, const glm::uvec3& triangle)
{
    const auto at = [&](glm::uint index) { return glm::dvec3(mesh.vertices.at(index).position); };
    return { at(triangle.x), at(triangle.y), at(triangle.z) };
}

// On the side of counter-clockwise corners, twice the area long.
inline glm::dvec3 areaNormal(const Mesh& mesh, const glm::uvec3& triangle)
{
    const auto [a, b, c] = corners(mesh, triangle);
    return glm::cross(b - a, c - a);
}

// A sixth of the sum of the spanned parallelepipeds (Gauss): positive if a closed mesh is counter-clockwise from
// outside.
inline double signedVolume(const Mesh& mesh)
{
    double sum = 0.0;
    for (const glm::uvec3& triangle : mesh.triangles) {
        const auto [a, b, c] = corners(mesh, triangle);
        sum += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return sum;
}

// For each vertex the first one that lies within the tolerance of it on each axis.
inline std::vector<std::size_t> weld(const Mesh& mesh, double tolerance)
{
    const auto before = [tolerance](const glm::dvec3& a, const glm::dvec3& b) {
        for (int axis = 0; axis < 3; ++axis) {
            if (std::abs(a[axis] - b[axis]) > tolerance)
                return a[axis] < b[axis];
        }
        return false;
    };
    std::map<glm::dvec3, std::size_t, decltype(before)> first(before);
    std::vector<std::size_t> welded;
    for (const Vertex& vertex : mesh.vertices)
        welded.push_back(first.try_emplace(vertex.position, welded.size()).first->second);
    return welded;
}

// How often the triangles run along each edge, in its direction.
inline std::map<Edge, int> directedEdges(const Mesh& mesh, const std::vector<std::size_t>& welded)
{
    std::map<Edge, int> count;
    for (const glm::uvec3& triangle : mesh.triangles) {
        for (int i = 0; i < 3; ++i)
            ++count[{ welded[triangle[i]], welded[triangle[(i + 1) % 3]] }];
    }
    return count;
}

// The edges that only one triangle has; all others must have one triangle on each side.
inline std::vector<Edge> openEdges(const std::map<Edge, int>& edges)
{
    std::vector<Edge> open;
    for (const auto& [edge, count] : edges) {
        if (!edges.contains({ edge[1], edge[0] }))
            open.push_back(edge);
    }
    return open;
}

// Whether the triangles around each vertex form one closed fan: no two parts of the surface touch in it. For closed
// meshes.
inline bool hasOneFanAtEachVertex(const Mesh& mesh, const std::vector<std::size_t>& welded)
{
    std::map<std::size_t, std::map<std::size_t, std::size_t>>
        opposite; // of each vertex, where the edge opposite it goes
    for (const glm::uvec3& triangle : mesh.triangles) {
        for (int i = 0; i < 3; ++i)
            opposite[welded[triangle[i]]][welded[triangle[(i + 1) % 3]]] = welded[triangle[(i + 2) % 3]];
    }
    for (const auto& [vertex, next] : opposite) {
        std::size_t length = 0, at = next.begin()->first;
        do {
            at = next.at(at);
            ++length;
        } while (at != next.begin()->first);
        if (length != next.size())
            return false;
    }
    return true;
}

}
