#pragma once
#include "grading/random.h"
#include <cmath>
#include <limits>

namespace stress {

// An engine that costs nothing to seed, for every case has a seed of its own. Steele, Lea and Flood 2014, "Fast
// Splittable Pseudorandom Number Generators".
class SplitMix {
public:
    using result_type = uint64_t;

    explicit SplitMix(uint64_t seed = 0)
        : m_state(seed)
    {
    }

    void seed(uint64_t seed) { m_state = seed; }

    uint64_t operator()()
    {
        uint64_t z = m_state += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    static constexpr uint64_t min() { return 0; }
    static constexpr uint64_t max() { return std::numeric_limits<uint64_t>::max(); }

private:
    uint64_t m_state;
};

// What a random case is made of.
using Random = grading::RandomOf<SplitMix>;

// Of any order of magnitude between two positive numbers, all alike.
[[nodiscard]] inline float magnitude(Random& random, float lower, float upper)
{
    return std::exp2(random.uniform(std::log2(lower), std::log2(upper)));
}

}
