#pragma once
#include "bvh_interface.h"
#include <algorithm>
#include <vector>

namespace accel {

// The triangles of all meshes, one after the other, where the scene has them.
class SceneTriangles {
public:
    SceneTriangles() = default; // none

    explicit SceneTriangles(std::span<const Mesh> meshes)
        : m_meshes(meshes)
    {
        for (const Mesh& mesh : meshes)
            m_ends.push_back(size() + static_cast<uint32_t>(mesh.triangles.size()));
    }

    [[nodiscard]] uint32_t size() const { return m_ends.empty() ? 0 : m_ends.back(); }

    [[nodiscard]] BVHInterface::Primitive operator[](uint32_t index) const
    {
        const auto end = std::ranges::upper_bound(m_ends, index);
        const auto meshID = static_cast<uint32_t>(end - m_ends.begin());
        const Mesh& mesh = m_meshes[meshID];
        const glm::uvec3& t = mesh.triangles[index + mesh.triangles.size() - *end];
        return { meshID, mesh.vertices[t.x], mesh.vertices[t.y], mesh.vertices[t.z] };
    }

private:
    std::span<const Mesh> m_meshes;
    std::vector<uint32_t> m_ends; // of each mesh's
};

}
