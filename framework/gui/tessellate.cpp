#include "gui/tessellate.h"
#include <glm/gtc/constants.hpp>

namespace gui {

// Rings of latitude from pole to pole, of as many vertices each; at the poles these fall together.
Mesh tessellate(const Sphere& sphere)
{
    constexpr uint32_t rings = 64, sectors = 128; // 0.0006 radii inside of the sphere at most
    Mesh mesh { .material = sphere.material };
    for (uint32_t ring = 0; ring <= rings; ++ring)
        for (uint32_t sector = 0; sector <= sectors; ++sector) {
            const float theta = glm::pi<float>() * static_cast<float>(ring) / static_cast<float>(rings);
            const float phi = glm::two_pi<float>() * static_cast<float>(sector) / static_cast<float>(sectors);
            const glm::vec3 normal { std::sin(theta) * std::cos(phi), std::cos(theta),
                std::sin(theta) * std::sin(phi) };
            mesh.vertices.push_back({ sphere.center + sphere.radius * normal, normal, glm::vec2(0.0f) });
        }
    for (uint32_t ring = 0; ring < rings; ++ring)
        for (uint32_t sector = 0; sector < sectors; ++sector) {
            const uint32_t here = ring * (sectors + 1) + sector, below = here + sectors + 1;
            mesh.triangles.emplace_back(here, below, here + 1);
            mesh.triangles.emplace_back(here + 1, below, below + 1);
        }
    return mesh;
}

}
