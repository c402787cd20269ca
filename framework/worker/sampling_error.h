#pragma once
#include <cstdint>

namespace worker {

enum class Strategy : uint32_t { Uniform, Stratified, Owen };

// What is sampled, of which the truth is known.
enum class Integrand : uint32_t {
    Edge, // pixels that a slanting edge crosses
    AxisEdge, // pixels that an edge crosses along their rows
    SoftShadow, // a light that is blocked in part
    Smooth, // a light that is not
};

// What the probe render.error is asked for.
struct ErrorRequest {
    Integrand integrand;
    Strategy strategy;
    uint32_t numSamples; // a pixel, or a light
    uint32_t numEstimates; // each with random numbers of its own
    uint32_t seed;
};

struct ErrorAnswer {
    double meanSquare; // of the estimates' distance from the truth
    double mean; // of that distance: no more than chance explains
    double seconds; // for all estimates
};

}
