#include "shapes/teapot_patches.h"
#include <span>

namespace shapes {
namespace {

    // Control points as published in Crow 1987, "The Origins of the Teapot", IEEE Computer Graphics and
    // Applications 7(1), with the bottom that was added later. All patches are mirror images of ten, and the
    // points of those lie on rings around the axis or on hoops around handle and spout.

    // A quarter of a ring runs (radius, 0), (radius, bulge), (bulge, radius), (0, radius).
    struct Ring {
        float radius, height;
        float bulge = 0.56f * radius; // close to the 0.5523 of a circle
    };

    constexpr Ring rim[] { { 1.4f, 2.4f }, { 1.3375f, 2.53125f }, { 1.4375f, 2.53125f }, { 1.5f, 2.4f } };
    constexpr Ring upperBody[] { { 1.5f, 2.4f }, { 1.75f, 1.875f }, { 2.0f, 1.35f }, { 2.0f, 0.9f } };
    constexpr Ring lowerBody[] { { 2.0f, 0.9f }, { 2.0f, 0.45f }, { 1.5f, 0.225f }, { 1.5f, 0.15f } };
    constexpr Ring bottom[] { { 1.5f, 0.15f }, { 1.5f, 0.075f }, { 1.425f, 0.0f }, { 0.0f, 0.0f } };
    constexpr Ring knob[] { { 0.0f, 3.15f }, { 0.8f, 3.15f, 0.45f }, { 0.0f, 2.85f }, { 0.2f, 2.7f } };
    constexpr Ring lid[] { { 0.2f, 2.7f }, { 0.4f, 2.55f }, { 1.3f, 2.55f }, { 1.3f, 2.4f } };

    // Half a hoop runs from (x0, y0, 0) over (x0, y0, width) and (x1, y1, width) to (x1, y1, 0).
    struct Hoop {
        float x0, y0, x1, y1, width;
    };

    constexpr Hoop upperHandle[] {
        { -1.6f, 2.025f, -1.5f, 2.25f, 0.3f },
        { -2.3f, 2.025f, -2.5f, 2.25f, 0.3f },
        { -2.7f, 2.025f, -3.0f, 2.25f, 0.3f },
        { -2.7f, 1.8f, -3.0f, 1.8f, 0.3f },
    };
    constexpr Hoop lowerHandle[] {
        { -2.7f, 1.8f, -3.0f, 1.8f, 0.3f },
        { -2.7f, 1.575f, -3.0f, 1.35f, 0.3f },
        { -2.5f, 1.125f, -2.65f, 0.9375f, 0.3f },
        { -2.0f, 0.9f, -1.9f, 0.6f, 0.3f },
    };
    constexpr Hoop lowerSpout[] {
        { 1.7f, 1.425f, 1.7f, 0.6f, 0.66f },
        { 2.6f, 1.425f, 3.1f, 0.825f, 0.66f },
        { 2.3f, 2.1f, 2.4f, 2.025f, 0.25f },
        { 2.7f, 2.4f, 3.3f, 2.4f, 0.25f },
    };
    constexpr Hoop upperSpout[] {
        { 2.7f, 2.4f, 3.3f, 2.4f, 0.25f },
        { 2.8f, 2.475f, 3.525f, 2.49375f, 0.25f },
        { 2.9f, 2.475f, 3.45f, 2.5125f, 0.15f },
        { 2.8f, 2.4f, 3.2f, 2.4f, 0.15f },
    };

    void addRings(std::vector<BezierPatch>& patches, std::span<const Ring, 4> rings)
    {
        // Each quarter runs from one axis to the next.
        constexpr glm::vec3 axes[] { { 1, 0, 0 }, { 0, 0, 1 }, { -1, 0, 0 }, { 0, 0, -1 }, { 1, 0, 0 } };
        for (std::size_t quarter = 0; quarter < 4; ++quarter) {
            const glm::vec3 from = axes[quarter], to = axes[quarter + 1];
            BezierPatch& patch = patches.emplace_back();
            for (std::size_t i = 0; i < 4; ++i) {
                const auto [radius, height, bulge] = rings[i];
                const glm::vec3 center { 0.0f, height, 0.0f };
                patch.rows[i] = { center + radius * from, center + radius * from + bulge * to,
                    center + bulge * from + radius * to, center + radius * to };
            }
        }
    }

    void addHoops(std::vector<BezierPatch>& patches, std::span<const Hoop, 4> hoops)
    {
        BezierPatch& front = patches.emplace_back();
        BezierPatch& back = patches.emplace_back();
        for (std::size_t i = 0; i < 4; ++i) {
            const auto [x0, y0, x1, y1, width] = hoops[i];
            const glm::vec3 inner { x0, y0, 0.0f }, outer { x1, y1, 0.0f }, across { 0.0f, 0.0f, width };
            front.rows[i] = { inner, inner + across, outer + across, outer };
            back.rows[i] = { outer, outer - across, inner - across, inner };
        }
    }

}

std::vector<BezierPatch> teapotPatches()
{
    std::vector<BezierPatch> patches;
    patches.reserve(32); // addHoops holds on to two at a time
    for (const auto& rings : { rim, upperBody, lowerBody, bottom, knob, lid })
        addRings(patches, std::span<const Ring, 4>(rings, 4));
    for (const auto& hoops : { upperHandle, lowerHandle, lowerSpout, upperSpout })
        addHoops(patches, std::span<const Hoop, 4>(hoops, 4));
    return patches;
}

}
