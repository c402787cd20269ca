#include "grading/stress/texture_inputs.h"
#include "grading/stress/rounding.h"
#include <array>
#include <cfloat>

namespace stress {
namespace {

    // The index of the last texels of the two largest is beyond 2^24, where a float holds even numbers alone.
    const std::array<glm::ivec2, 12> sizes { { { 1, 1 }, { 2, 2 }, { 7, 5 }, { 5, 9 }, { 3, 1 }, { 1, 16384 },
        { 16384, 1 }, { 64, 32 }, { 255, 3 }, { 1000, 999 }, { 16384, 1030 }, { 1031, 16384 } } };

    float coordinate(Random& random, int size)
    {
        const auto texels = static_cast<float>(size);
        const auto i = static_cast<float>(random.integer(0, size));
        switch (random.integer(0, 4)) {
        case 0: // a border, or beside it
            return stepped(i / texels, random.integer(-3, 3));
        case 1: // a centre, or beside it
            return stepped((i + 0.5f) / texels, random.integer(-3, 3));
        case 2:
            return magnitude(random, 1e-30f, 1e30f) * (random.integer(0, 1) == 0 ? 1.0f : -1.0f);
        default:
            return random.uniform(-0.25f, 1.25f);
        }
    }

    using Named = std::pair<std::string, Lookup>;

    const std::array<std::pair<const char*, float>, 17> coordinates { {
        { "0", 0.0f },
        { "negative zero", -0.0f },
        { "1", 1.0f },
        { "just below 1", 0x1.fffffep-1f },
        { "just above 1", 0x1.000002p0f },
        { "just below 0", -FLT_MIN },
        { "denormal", 1e-45f },
        { "-0.3", -0.3f },
        { "-1", -1.0f },
        { "2", 2.0f },
        { "1e9", 1e9f },
        { "-1e9", -1e9f },
        { "the largest float", FLT_MAX },
        { "the lowest float", -FLT_MAX },
        { "infinity", std::numeric_limits<float>::infinity() },
        { "minus infinity", -std::numeric_limits<float>::infinity() },
        { "NaN", std::numeric_limits<float>::quiet_NaN() },
    } };

}

Lookup anywhere(Random& random)
{
    const glm::ivec2 size = sizes[static_cast<std::size_t>(random.integer(0, static_cast<int>(sizes.size()) - 1))];
    const float u = coordinate(random, size.x);
    return { size, { u, coordinate(random, size.y) } };
}

Lookup exactCentre(Random& random)
{
    const glm::ivec2 size = random.integer(0, 1) == 0 ? glm::ivec2(64, 32) : glm::ivec2(16384, 1);
    const glm::vec2 texel { random.integer(0, size.x - 1), random.integer(0, size.y - 1) };
    return { size, (texel + 0.5f) / glm::vec2(size) };
}

std::vector<Named> specialLookups()
{
    constexpr float within = 0.37f;
    std::vector<Named> named;
    for (const auto& [name, x] : coordinates) {
        named.emplace_back(fmt::format("u is {}", name), Lookup { { 7, 5 }, { x, within } });
        named.emplace_back(fmt::format("v is {}", name), Lookup { { 7, 5 }, { within, x } });
        named.emplace_back(fmt::format("of one texel, both are {}", name), Lookup { { 1, 1 }, { x, x } });
    }
    named.emplace_back("the last texel of a wide image", Lookup { { 16384, 1030 }, glm::vec2(0x1.fffffep-1f) });
    named.emplace_back("the last texel of a high image", Lookup { { 1031, 16384 }, glm::vec2(0x1.fffffep-1f) });
    return named;
}

}
