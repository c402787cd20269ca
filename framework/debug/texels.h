#pragma once
#include <framework/image.h>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace debug {

struct Texel {
    glm::ivec2 index { 0 }; // column, row
    float weight = 0.0f;
};

using SampleTexture = std::function<glm::vec3(const Image&, const glm::vec2&)>;

// Which texels of an image of that size a lookup takes, and how much of each. Found out by asking the function about
// images that are white in parts and black elsewhere, so that it is the truth about any function that mixes texels.
[[nodiscard]] std::vector<Texel> texelsOf(const SampleTexture& sample, glm::ivec2 size, const glm::vec2& texCoord);

}
