#include "files/obj_mesh.h"
#include <glm/geometric.hpp>

namespace files {

void ObjMeshBuilder::addTriangle(const std::array<ObjCorner, 3>& corners)
{
    m_mesh.triangles.push_back({ vertexAt(corners[0]), vertexAt(corners[1]), vertexAt(corners[2]) });
}

std::size_t ObjMeshBuilder::Hash::operator()(const ObjCorner& corner) const
{
    constexpr std::size_t multiplier = 0x9e3779b97f4a7c15u; // Knuth, The Art of Computer Programming 3, 6.4
    std::size_t hash = 0;
    for (const int index : { corner.position, corner.texCoord, corner.normal })
        hash = (hash ^ static_cast<std::size_t>(index)) * multiplier;
    return hash;
}

uint32_t ObjMeshBuilder::vertexAt(const ObjCorner& corner)
{
    const auto next = static_cast<uint32_t>(m_mesh.vertices.size());
    const auto [entry, isNew] = m_vertices.emplace(corner, next);
    if (isNew)
        m_mesh.vertices.push_back(makeVertex(corner));
    return entry->second;
}

Vertex ObjMeshBuilder::makeVertex(const ObjCorner& corner) const
{
    const auto position = static_cast<std::size_t>(corner.position);
    Vertex vertex { m_data.positions[position], m_smoothNormals[position], glm::vec2(0.0f) };
    if (corner.normal >= 0) {
        const glm::dvec3 normal = m_data.normals[static_cast<std::size_t>(corner.normal)];
        if (const double length = glm::length(normal); length > 0.0) // some exporters write 0 0 0
            vertex.normal = normal / length;
    }
    if (corner.texCoord >= 0)
        vertex.texCoord = m_data.texCoords[static_cast<std::size_t>(corner.texCoord)];
    return vertex;
}

}
