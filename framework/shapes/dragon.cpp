#include "shapes/makers.h"
#include "shapes/surface_nets.h"
#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/geometric.hpp>

namespace shapes {
namespace {

    // A point of the curve that the body follows.
    struct Joint {
        glm::vec3 position;
        float radius;
    };

    // From the tip of the tail to the nape; bends up and down, and never runs along z for long.
    constexpr std::array<Joint, 14> spine { {
        { { -1.62f, 0.62f, 0.10f }, 0.012f },
        { { -1.42f, 0.80f, 0.14f }, 0.035f },
        { { -1.16f, 0.66f, 0.10f }, 0.060f },
        { { -1.05f, 0.34f, 0.00f }, 0.085f },
        { { -0.84f, 0.10f, -0.10f }, 0.110f },
        { { -0.55f, 0.18f, -0.12f }, 0.135f },
        { { -0.33f, 0.48f, -0.04f }, 0.150f },
        { { -0.05f, 0.68f, 0.08f }, 0.160f },
        { { 0.24f, 0.52f, 0.10f }, 0.170f },
        { { 0.42f, 0.24f, 0.02f }, 0.175f },
        { { 0.70f, 0.12f, -0.08f }, 0.170f },
        { { 0.95f, 0.34f, -0.08f }, 0.150f },
        { { 0.98f, 0.70f, 0.00f }, 0.125f },
        { { 1.14f, 0.98f, 0.00f }, 0.110f },
    } };

    // The spine at a place in [0, spine.size() - 1]. Catmull and Rom 1974.
    Joint onSpine(float place)
    {
        const auto last = spine.size() - 1;
        const auto i = std::min(static_cast<std::size_t>(place), last - 1);
        const float t = place - static_cast<float>(i);
        const Joint &p0 = spine[i == 0 ? 0 : i - 1], &p1 = spine[i], &p2 = spine[i + 1],
                    &p3 = spine[std::min(i + 2, last)];
        const auto blend = [t](const auto& a, const auto& b, const auto& c, const auto& d) {
            return 0.5f
                * (2.0f * b + t * (c - a + t * (2.0f * a - 5.0f * b + 4.0f * c - d + t * (3.0f * (b - c) + d - a))));
        };
        return { blend(p0.position, p1.position, p2.position, p3.position),
            blend(p0.radius, p1.radius, p2.radius, p3.radius) };
    }

    constexpr float spineLength = static_cast<float>(spine.size() - 1);

    void addBody(Solid& dragon)
    {
        constexpr int segments = 60;
        Joint from = onSpine(0.0f);
        for (int i = 1; i <= segments; ++i) {
            const Joint to = onSpine(spineLength * static_cast<float>(i) / segments);
            dragon.add({ from.position, to.position, from.radius, to.radius }, 0.02f);
            from = to;
        }
    }

    // Away from the belly, square to the spine.
    glm::vec3 backward(float place)
    {
        const glm::vec3 along = onSpine(place + 0.05f).position - onSpine(place - 0.05f).position;
        return glm::normalize(glm::cross(glm::vec3(0.0f, 0.0f, 1.0f), along));
    }

    void addSpikes(Solid& dragon)
    {
        for (float place = 1.0f; place < spineLength - 0.2f; place += 0.25f) {
            const Joint joint = onSpine(place);
            const glm::vec3 up = backward(place);
            const glm::vec3 towardsTail = glm::normalize(onSpine(place - 0.1f).position - joint.position);
            const glm::vec3 root = joint.position + 0.85f * joint.radius * up;
            const float length = 0.04f + 0.75f * joint.radius;
            dragon.add({ root, root + length * (up + 0.5f * towardsTail), 0.3f * joint.radius, 0.009f }, 0.02f);
        }
    }

    void addLeg(Solid& dragon, const glm::vec3& hip, const glm::vec3& knee, const glm::vec3& foot)
    {
        dragon.add({ hip, knee, 0.10f, 0.06f }, 0.05f);
        dragon.add({ knee, foot, 0.06f, 0.04f }, 0.03f);
        for (const float spread : { -0.07f, 0.0f, 0.07f }) {
            const glm::vec3 toe = foot + glm::vec3(0.10f, -0.02f, spread);
            dragon.add({ foot, toe, 0.035f, 0.025f }, 0.02f);
            dragon.add({ toe, toe + glm::vec3(0.06f, -0.035f, 0.3f * spread), 0.02f, 0.008f }, 0.01f);
        }
    }

    void addLegs(Solid& dragon)
    {
        for (const float side : { -1.0f, 1.0f }) {
            const auto at = [side](float x, float y, float z) { return glm::vec3(x, y, side * z - 0.08f); };
            addLeg(dragon, at(0.72f, 0.12f, 0.10f), at(0.66f, -0.08f, 0.26f), at(0.82f, -0.26f, 0.28f));
            addLeg(dragon, at(-0.62f, 0.14f, 0.08f), at(-0.60f, -0.08f, 0.24f), at(-0.50f, -0.26f, 0.26f));
        }
    }

    void addHead(Solid& dragon)
    {
        const glm::vec3 skull { 1.22f, 1.06f, 0.0f };
        const auto at = [&](float x, float y, float z) { return skull + glm::vec3(x, y, z); };
        dragon.add({ skull, at(0.08f, 0.02f, 0.0f), 0.13f, 0.12f }, 0.06f);
        dragon.add({ at(0.08f, 0.01f, 0.0f), at(0.38f, -0.02f, 0.0f), 0.10f, 0.062f, { 1.0f, 0.9f, 1.1f } }, 0.05f);
        dragon.add({ at(0.02f, -0.08f, 0.0f), at(0.30f, -0.19f, 0.0f), 0.06f, 0.038f }, 0.03f); // lower jaw
        for (const float side : { -1.0f, 1.0f }) {
            dragon.add({ at(0.40f, 0.03f, side * 0.045f), at(0.40f, 0.03f, side * 0.045f), 0.035f, 0.035f }, 0.02f);
            dragon.add({ at(0.02f, 0.11f, side * 0.07f), at(0.16f, 0.09f, side * 0.09f), 0.03f, 0.03f }, 0.03f);
            const glm::vec3 eye = at(0.12f, 0.055f, side * 0.105f);
            dragon.add({ eye, eye, 0.035f, 0.035f }, 0.005f);
            dragon.add({ at(-0.04f, 0.09f, side * 0.07f), at(-0.22f, 0.24f, side * 0.14f), 0.04f, 0.026f }, 0.02f);
            dragon.add({ at(-0.22f, 0.24f, side * 0.14f), at(-0.44f, 0.27f, side * 0.16f), 0.026f, 0.009f }, 0.01f);
            dragon.add({ at(-0.02f, -0.02f, side * 0.10f), at(-0.20f, -0.02f, side * 0.24f), 0.05f, 0.01f }, 0.03f);
        }
    }

}

Mesh makeDragon()
{
    Solid dragon;
    addBody(dragon);
    addLegs(dragon);
    addHead(dragon);
    addSpikes(dragon);
    return polygonise(dragon, spine[8].position, 0.0128f);
}

}
