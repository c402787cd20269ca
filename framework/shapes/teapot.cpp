#include "shapes/makers.h"
#include "shapes/teapot_patches.h"

namespace shapes {
namespace {

    constexpr glm::uint steps = 15; // along each side of a patch

    // A grid of quads with the texture once on the patch. Patches that share an edge share its control points, so the
    // grids meet without gaps.
    void addPatch(Mesh& mesh, const BezierPatch& patch)
    {
        const auto first = static_cast<glm::uint>(mesh.vertices.size());
        for (glm::uint i = 0; i <= steps; ++i) {
            for (glm::uint j = 0; j <= steps; ++j) {
                const glm::vec2 uv = glm::vec2(j, i) / static_cast<float>(steps);
                mesh.vertices.push_back({ patch.position(uv.x, uv.y), patch.normal(uv.x, uv.y), uv });
            }
        }
        const bool startsInPoint = patch.collapsesAt(0.0f), endsInPoint = patch.collapsesAt(1.0f);
        for (glm::uint i = 0; i < steps; ++i) {
            for (glm::uint j = 0; j < steps; ++j) {
                const glm::uint corner = first + i * (steps + 1) + j, next = corner + steps + 1;
                if (!(startsInPoint && i == 0))
                    mesh.triangles.emplace_back(corner, corner + 1, next + 1);
                if (!(endsInPoint && i + 1 == steps))
                    mesh.triangles.emplace_back(corner, next + 1, next);
            }
        }
    }

}

Mesh makeTeapot()
{
    Mesh teapot;
    for (const BezierPatch& patch : teapotPatches())
        addPatch(teapot, patch);
    return teapot;
}

}
