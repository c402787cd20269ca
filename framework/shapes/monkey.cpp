#include "shapes/makers.h"
#include "shapes/surface_nets.h"

namespace shapes {
namespace {

    Limb ball(const glm::vec3& center, float radius, const glm::vec3& stretch = glm::vec3(1.0f))
    {
        return { center, center, radius, radius, stretch };
    }

    Limb mirrored(Limb limb)
    {
        limb.from.x = -limb.from.x;
        limb.to.x = -limb.to.x;
        return limb;
    }

    Solid monkeyHead()
    {
        Solid head;
        const auto addPair = [&](const Limb& limb, float blend) {
            head.add(limb, blend);
            head.add(mirrored(limb), blend);
        };
        const auto carvePair = [&](const Limb& limb, float blend) {
            head.carve(limb, blend);
            head.carve(mirrored(limb), blend);
        };
        head.add(ball({ 0.0f, 0.25f, 0.1f }, 0.9f, { 1.0f, 1.0f, 0.9f }), 0.0f); // skull
        addPair(ball({ 1.02f, 0.22f, 0.05f }, 0.46f, { 1.0f, 1.1f, 0.55f }), 0.15f); // ears
        carvePair(ball({ 1.06f, 0.22f, -0.28f }, 0.34f, { 1.0f, 1.1f, 0.8f }), 0.05f);
        addPair({ { 0.1f, 0.62f, -0.58f }, { 0.5f, 0.57f, -0.46f }, 0.2f, 0.17f }, 0.15f); // brows
        carvePair(ball({ 0.36f, 0.25f, -0.92f }, 0.34f), 0.1f); // eye sockets
        addPair(ball({ 0.34f, 0.26f, -0.57f }, 0.24f), 0.02f); // eyes
        head.add(ball({ 0.0f, -0.36f, -0.45f }, 0.58f, { 1.15f, 0.85f, 1.05f }), 0.2f); // muzzle
        head.add({ { 0.0f, 0.2f, -0.72f }, { 0.0f, -0.06f, -0.96f }, 0.12f, 0.16f }, 0.12f); // nose
        head.carve({ { -0.4f, -0.45f, -1.0f }, { 0.4f, -0.45f, -1.0f }, 0.15f, 0.15f }, 0.06f); // mouth
        return head;
    }

}

Mesh makeMonkey()
{
    return polygonise(monkeyHead(), glm::vec3(0.0f), 0.18f);
}

}
