#include "values/scene_of.h"

namespace values {

Scene sceneOf(std::span<const std::array<glm::vec3, 3>> triangles)
{
    Scene scene;
    Mesh& mesh = scene.meshes.emplace_back();
    for (const auto& triangle : triangles) {
        const auto first = static_cast<uint32_t>(mesh.vertices.size());
        for (const glm::vec3& corner : triangle)
            mesh.vertices.push_back({ corner, {}, {} });
        mesh.triangles.emplace_back(first, first + 1, first + 2);
    }
    return scene;
}

}
