#pragma once
#include "worker/integrand.h"
#include "worker/message.h"

namespace worker {

// Pairs: points of two numbers, of which each is even alone. Of lights only.
enum class Strategy : uint32_t { Uniform, Stratified, Owen, Pairs };

// What the probe sampling.estimates is asked for.
struct EstimateRequest {
    Integrand integrand;
    Strategy strategy;
    uint32_t numSamples; // a pixel, or a light
    uint32_t number; // of estimates, over all places in turn, each with random numbers of its own
    uint32_t seed;
};

struct Estimates {
    std::vector<float> values;
    double secondsEach = 0.0;
};

// By the submission's functions.
[[nodiscard]] Estimates estimate(const EstimateRequest& request);

inline Message& operator<<(Message& message, const Estimates& e)
{
    return message << e.values << e.secondsEach;
}

inline Reader& operator>>(Reader& reader, Estimates& e)
{
    return reader >> e.values >> e.secondsEach;
}

}
