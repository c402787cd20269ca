#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// A part of the report with a text of its own, text/<name>.md.
struct Section {
    std::string name; // as the grader names the feature
    std::string title;
    std::string file; // of the submission, without .cpp
    std::vector<std::string> keywords; // parts of the names of its functions, where a file serves two sections
};

inline const std::array<Section, 8> sections { {
    { "shading", "Shading", "shading", {} },
    { "reflection", "Reflections", "recursive", { "Reflection", "Specular" } },
    { "transparency", "Transparency", "recursive", { "Passthrough", "Transparent" } },
    { "bvh", "BVH traversal", "bvh", {} },
    { "interpolation", "Interpolation", "interpolate", {} },
    { "texture", "Texture mapping", "texture", {} },
    { "light", "Lights and shadows", "light", {} },
    { "multisampling", "Multisampling", "render", {} },
} };

// The functions that a section's author writes, such as LinearGradient::sample.
[[nodiscard]] std::vector<std::string> functionsOf(const Section& section);

// The same by the section's name; none for the parts of the report that are no such section.
[[nodiscard]] std::vector<std::string> functionsOf(std::string_view section);

}
