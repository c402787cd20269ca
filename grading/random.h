#pragma once
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <random>
#include <string_view>

namespace grading {

// Random inputs, from an engine of 64 bits.
template <typename Engine> class RandomOf {
public:
    explicit RandomOf(uint64_t seed)
        : m_engine(seed)
    {
    }

    // Others for each name.
    RandomOf(uint64_t seed, std::string_view name)
    {
        uint64_t hash = 0xcbf29ce484222325u ^ seed; // FNV-1a
        for (const char c : name)
            hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
        m_engine.seed(hash);
    }

    // Uniform in [lower, upper).
    [[nodiscard]] float uniform(float lower = 0.0f, float upper = 1.0f)
    {
        const auto bits = static_cast<float>(m_engine() >> 40);
        return lower + (upper - lower) * (bits * 0x1p-24f);
    }

    // Uniform in {lower, ..., upper}.
    [[nodiscard]] int integer(int lower, int upper)
    {
        return lower + static_cast<int>(m_engine() % static_cast<uint64_t>(upper - lower + 1));
    }

    [[nodiscard]] glm::vec2 vec2(float lower = 0.0f, float upper = 1.0f)
    {
        const float x = uniform(lower, upper);
        return { x, uniform(lower, upper) };
    }

    [[nodiscard]] glm::vec3 vec3(float lower = 0.0f, float upper = 1.0f)
    {
        const glm::vec2 xy = vec2(lower, upper);
        return { xy, uniform(lower, upper) };
    }

    // A colour whose channels differ and are neither 0 nor 1: a mistake in one of them shows.
    [[nodiscard]] glm::vec3 color() { return vec3(0.1f, 0.9f); }

    // A unit vector, all directions alike.
    [[nodiscard]] glm::vec3 direction()
    {
        for (;;) {
            const glm::vec3 v = vec3(-1.0f, 1.0f);
            const float squared = glm::dot(v, v);
            if (squared > 0.01f && squared < 1.0f)
                return glm::normalize(v);
        }
    }

    [[nodiscard]] uint32_t seed() { return static_cast<uint32_t>(m_engine()); }

private:
    Engine m_engine;
};

// Those of a check or a test.
using Random = RandomOf<std::mt19937_64>;

}
