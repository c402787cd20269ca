#pragma once
#include "grading/probes/shading_case.h"
#include "shading.h"

// What the probes of shading models are asked, and answer.
namespace stress {

struct Models {
    glm::vec3 lambertian, phong, blinnPhong;
};

// Two points to be compared by one gradient.
struct Comparisons {
    grading::ShadingCase phongIsBrighter, blinnPhongIsBrighter;
};

struct ComparisonColors {
    glm::vec3 phongIsBrighter, blinnPhongIsBrighter;
};

// No steeper than 1 anywhere, so that a cosine's rounding shows no larger than it is.
inline const LinearGradient gentleGradient { .components = {
                                                 { 0.5f, { 0.6f, 0.2f, 0.7f } },
                                                 { -1.0f, { 0.8f, 0.1f, 0.6f } },
                                                 { 1.0f, { 0.9f, 0.5f, 0.4f } },
                                                 { -0.25f, { 0.3f, 0.4f, 0.5f } },
                                             } };

// Tells a difference from its colour: red is what lies below 0, blue above, and the sum of all channels 1.
inline const LinearGradient sidesOfZero { .components
    = { { -1.0f, { 1, 0, 0 } }, { 0.0f, { 0, 1, 0 } }, { 1.0f, { 0, 0, 1 } } } };

}
