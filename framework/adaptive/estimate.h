#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace adaptive {

// What is known of a pixel's colour from so many of its rays. In double precision: nothing is lost over millions.
struct Estimate {
    std::array<glm::dvec3, 2> halves {}; // the means of the first half of the rays and of the others
    double variance = 0.0; // of the mean as it is shown, in [0, 1]; the mean of the three channels'
    uint32_t numRays = 0;

    [[nodiscard]] glm::dvec3 mean() const { return 0.5 * (halves[0] + halves[1]); }
};

// From the means of four quarters of the rays.
[[nodiscard]] Estimate estimateFrom(const std::array<glm::dvec3, 4>& quarters, uint32_t numRays);

// The same with twice as many rays, from the means of two halves of the new ones.
[[nodiscard]] Estimate doubled(const Estimate& estimate, const std::array<glm::dvec3, 2>& newHalves);

}
