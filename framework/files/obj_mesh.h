#pragma once
#include "files/obj_data.h"
#include <framework/mesh.h>
#include <memory_resource>
#include <unordered_map>

namespace files {

// Makes a mesh of some triangles of an OBJ file: corners of the same position, normal and texture coordinates share a
// vertex. Those without a normal get the smooth one of their position.
class ObjMeshBuilder {
public:
    ObjMeshBuilder(const ObjData& data, const std::vector<glm::vec3>& smoothNormals)
        : m_data(data)
        , m_smoothNormals(smoothNormals)
    {
    }

    void addTriangle(const std::array<ObjCorner, 3>& corners);
    [[nodiscard]] Mesh take() { return std::move(m_mesh); }

private:
    struct Hash {
        std::size_t operator()(const ObjCorner& corner) const;
    };

    [[nodiscard]] uint32_t vertexAt(const ObjCorner& corner);
    [[nodiscard]] Vertex makeVertex(const ObjCorner& corner) const;

    const ObjData& m_data;
    const std::vector<glm::vec3>& m_smoothNormals;
    Mesh m_mesh;
    std::pmr::unsynchronized_pool_resource m_pool; // the map's many small pieces, side by side
    std::pmr::unordered_map<ObjCorner, uint32_t, Hash> m_vertices { &m_pool };
};

}
