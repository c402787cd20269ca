#pragma once
#include "grading/probes/incidence.h"
#include "grading/probes/light_sample.h"

// What the probes of lights are asked.
namespace stress {

struct SegmentSample {
    SegmentLight light;
    float sample;
};

struct ParallelogramSample {
    ParallelogramLight light;
    glm::vec2 sample;
};

// A light that shines on a point of a surface, with nothing else there.
struct Shining {
    enum class Kind { Point, Segment, Parallelogram };

    Kind kind; // a point and a segment are parallelograms without edges
    ParallelogramLight light;
    grading::Incidence shaded;
    ShadingModel model;
    uint32_t numSamples;
};

}
