#include "gui/tessellate.h"
#include <glm/gtc/constants.hpp>

namespace gui {

// Rings of latitude from pole to pole, of as many vertices each; at the poles these fall together.
Mesh tessellate(const Sphere& sphere)
{
    constexpr uint32_t rings = 32, sectors = 64;
    constexpr float step = glm::pi<float>() / static_cast<float>(rings);
    // The outline is a polygon: its corners lie as far out of the circle as the middles of its sides lie in it.
    const float reach = sphere.radius * 2.0f / (1.0f + std::cos(step / 2.0f));
    Mesh mesh { .material = sphere.material };
    for (uint32_t ring = 0; ring <= rings; ++ring)
        for (uint32_t sector = 0; sector <= sectors; ++sector) {
            const float theta = step * static_cast<float>(ring), phi = step * static_cast<float>(sector);
            const glm::vec3 normal { std::sin(theta) * std::cos(phi), std::cos(theta),
                std::sin(theta) * std::sin(phi) };
            mesh.vertices.push_back({ sphere.center + reach * normal, normal, glm::vec2(0.0f) });
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
