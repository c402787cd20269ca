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
    // OwenPairs: points whose coordinates are even each alone, in orders that do not depend on each other: a Latin
    // hypercube, McKay 1979.
    // Jittered ones are even within a ray only: each of those that are expected is anywhere in a cell of its own.
    enum class Method { Owen, OwenPairs, Jittered };

    // firstRay: how many of the pixel's rays came before, by whom also.
    explicit EvenNumbers(uint32_t seed, Method method = Method::Owen, uint32_t firstRay = 0)
        : m_seed(seed)
        , m_method(method)
        , m_firstRay(firstRay)
        , m_ray(firstRay)
    {
    }

    // From here on, numbers are this one's of the rays that come now, counted from 0.
    void startRay(uint32_t ray);

    // The next so many are for one purpose, and as many in each ray: together they are even. Others that are asked for
    // meanwhile are for purposes of their own.
    void expectNumbers(uint32_t number);
    void expectPoints(uint32_t number);

    // In [0, 1).
    [[nodiscard]] float next1d();
    [[nodiscard]] glm::vec2 next2d();

private:
    // Something that a ray needs so many samples for, and how many it has had.
    struct Purpose {
        uint32_t seed = 0, first = 0, number = 0, numHad = 0;
    };

    [[nodiscard]] uint32_t newSeed();
    [[nodiscard]] Purpose newPurpose(uint32_t number);
    [[nodiscard]] glm::vec2 nextOf(Purpose& purpose);
    [[nodiscard]] glm::vec2 nextUnexpected();
    [[nodiscard]] glm::vec2 pointOf(uint32_t index, uint32_t seed) const; // of a sequence

    uint32_t m_seed;
    Method m_method;
    uint32_t m_firstRay;
    uint32_t m_ray;
    uint32_t m_numPurposes = 0; // of this ray so far
    Purpose m_numbers, m_points;
};

}
