#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <random>

namespace values {
class EvenNumbers;
}

// A stream of uniform random numbers in [0, 1), never 1. Equal seeds give equal streams.
// PCG-XSH-RR, O'Neill 2014, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms".
class Sampler {
public:
    Sampler(uint32_t seed = std::random_device {}()) // implicit: course files write `.sampler = { seed }`
        : m_state(mix(seed))
    {
    }

    // Hands out these numbers, which are spread evenly and outlive it.
    explicit Sampler(values::EvenNumbers& even)
        : m_state(0)
        , m_even(&even)
    {
    }

    // Whom to tell what numbers are for; null if they are independent.
    [[nodiscard]] values::EvenNumbers* even() const { return m_even; }

    // 24 random bits: every value is a float, and the largest is 1 - 2^-24.
    [[nodiscard]] float next_1d()
    {
        if (m_even) [[unlikely]]
            return nextEven1d();
        return static_cast<float>(next() >> 8) * 0x1p-24f;
    }

    [[nodiscard]] glm::vec2 next_2d()
    {
        if (m_even) [[unlikely]]
            return nextEven2d();
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

    [[nodiscard]] float nextEven1d();
    [[nodiscard]] glm::vec2 nextEven2d();

    uint64_t m_state;
    values::EvenNumbers* m_even = nullptr;
};
