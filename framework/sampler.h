#pragma once
#include "values/even_numbers.h"
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <random>

// A stream of uniform random numbers in [0, 1), never 1. Equal seeds give equal streams.
// PCG-XSH-RR, O'Neill 2014, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms".
class Sampler {
public:
    Sampler(uint32_t seed = std::random_device {}()) // implicit: course files write `.sampler = { seed }`
        : m_state(mix(seed))
    {
    }

    // One whose numbers are spread evenly over a pixel's samples, as far as somebody says what they are for.
    [[nodiscard]] static Sampler even(uint32_t seed)
    {
        Sampler sampler(seed);
        sampler.m_even.emplace(seed);
        return sampler;
    }

    // One whose numbers are jittered in a grid of cells, for those that somebody says what they are for.
    [[nodiscard]] static Sampler jittered(uint32_t seed)
    {
        Sampler sampler(seed);
        sampler.m_even.emplace(seed, values::EvenNumbers::Method::Jittered);
        return sampler;
    }

    // Numbers that are spread evenly, or null.
    [[nodiscard]] values::EvenNumbers* even() { return m_even ? &*m_even : nullptr; }

    // 24 random bits: every value is a float, and the largest is 1 - 2^-24.
    [[nodiscard]] float next_1d()
    {
        if (m_even) [[unlikely]]
            return m_even->next1d();
        return static_cast<float>(next() >> 8) * 0x1p-24f;
    }

    [[nodiscard]] glm::vec2 next_2d()
    {
        if (m_even) [[unlikely]]
            return m_even->next2d();
        const float x = next_1d();
        return { x, next_1d() };
    }

private:
    static constexpr uint64_t multiplier = 6364136223846793005u;
    static constexpr uint64_t increment = 1442695040888963407u;

    // The finaliser of SplitMix64 (Steele, Lea, Flood 2014): neighbouring seeds start far apart.
    static constexpr uint64_t mix(uint64_t seed)
    {
        seed = (seed + 0x9e3779b97f4a7c15u) * 0xbf58476d1ce4e5b9u;
        seed = (seed ^ (seed >> 27)) * 0x94d049bb133111ebu;
        return seed ^ (seed >> 31);
    }

    uint32_t next()
    {
        const uint64_t old = m_state;
        m_state = old * multiplier + increment;
        const auto shifted = static_cast<uint32_t>(((old >> 18) ^ old) >> 27);
        const auto rotation = static_cast<uint32_t>(old >> 59);
        return (shifted >> rotation) | (shifted << (-rotation & 31));
    }

    uint64_t m_state;
    std::optional<values::EvenNumbers> m_even;
};
