#pragma once
#include <cstdint>
#include <glm/vec2.hpp>

namespace values {

// The random numbers of a pixel, by Owen's points (values/owen_sobol.h): of a power of two of its rays, or of samples
// in a ray, every box of the unit square gets its share. Each purpose has a sequence of its own, so that one does not
// depend on another. As "padding" in Burley 2020, section 3.
//
// Whoever asks for a number need not know; whoever knows what the next are for says so before.
class EvenNumbers {
public:
    explicit EvenNumbers(uint32_t seed)
        : m_seed(seed)
    {
    }

    // From here on, numbers are this one of the pixel's rays'.
    void startRay(uint32_t ray);

    // The next so many are for one purpose, and as many in each ray: together they are even. Others that are asked for
    // meanwhile are for purposes of their own.
    void expectNumbers(uint32_t number);
    void expectPoints(uint32_t number);

    // In [0, 1).
    [[nodiscard]] float next1d();
    [[nodiscard]] glm::vec2 next2d();

private:
    // A purpose, and how many of its samples are still to come.
    struct Purpose {
        uint32_t seed = 0, index = 0, numLeft = 0;
    };

    [[nodiscard]] uint32_t newSeed();
    [[nodiscard]] Purpose purposeOf(uint32_t number);
    [[nodiscard]] glm::vec2 next(Purpose& expected);

    uint32_t m_seed;
    uint32_t m_ray = 0;
    uint32_t m_numPurposes = 0; // of this ray so far
    Purpose m_numbers, m_points;
};

}
