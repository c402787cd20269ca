#pragma once
#include "adaptive/picture.h"
#include <optional>

namespace adaptive {

// When a picture is good enough: whichever comes first.
struct Goal {
    double error = 0x1p-20; // of no pixel believed to be above; 1 is from black to white
    std::optional<double> seconds; // no pixel is begun later; but all have their fewest rays
};

// progress: is told how far it is, in [0, 1], after each round.
[[nodiscard]] Picture render(
    const PixelRays& rays, glm::ivec2 size, const Goal& goal, const std::function<void(float)>& progress);

// What a picture took, and what it is believed to be worth.
struct Summary {
    double error = 0.0; // believed, root mean square of all pixels
    double largestError = 0.0; // of a pixel
    uint64_t numSamples = 0; // rays that begin at the camera
    uint32_t fewestSamples = 0, mostSamples = 0; // of a pixel
};

[[nodiscard]] Summary summarize(const Picture& picture);

}
