#pragma once
#include "common.h"
#include "worker/message.h"

namespace report {

// What the probe figures.light_samples is asked for: samples of a parallelogram light, by sampleParallelogramLight.
struct LightSamplesQuestion {
    ParallelogramLight light;
    uint32_t number = 0;
    uint32_t seedTwice1d = 0, seed2d = 0;
};

struct LightSample {
    glm::vec3 position, color;
};

struct LightSamples {
    std::vector<LightSample> twice1d; // a number from the sampler for one edge, another for the other
    std::vector<LightSample> once2d; // both at once
};

// What the probe figures.light_behind_pane is asked for: what visibilityOfLightSampleTransparency leaves of white
// light that comes through one pane, for panes of each opacity alpha.
struct PanesQuestion {
    glm::vec3 kd { 1.0f };
    std::vector<float> alphas;
    bool isProposed = false; // with enableProposedShadowFormula
};

inline worker::Message& operator<<(worker::Message& message, const LightSamples& s)
{
    return message << s.twice1d << s.once2d;
}

inline worker::Reader& operator>>(worker::Reader& reader, LightSamples& s)
{
    return reader >> s.twice1d >> s.once2d;
}

inline worker::Message& operator<<(worker::Message& message, const PanesQuestion& q)
{
    return message << q.kd << q.alphas << q.isProposed;
}

inline worker::Reader& operator>>(worker::Reader& reader, PanesQuestion& q)
{
    return reader >> q.kd >> q.alphas >> q.isProposed;
}

}
