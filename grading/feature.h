#pragma once
#include <array>
#include <string>

namespace grading {

// What is graded, in the order of the report.
struct Feature {
    std::string name;
    std::string file; // of the submission, without .cpp
    double points;
};

inline const std::array<Feature, 8> gradedFeatures { {
    { "shading", "shading", 10 },
    { "reflection", "recursive", 10 },
    { "transparency", "recursive", 10 },
    { "bvh", "bvh", 20 },
    { "interpolation", "interpolate", 10 },
    { "texture", "texture", 10 },
    { "light", "light", 20 },
    { "multisampling", "render", 10 },
} };

}
