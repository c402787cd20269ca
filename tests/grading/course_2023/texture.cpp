#include "texture.h"
#include "render.h"
#include "scene.h"
#include <fmt/core.h>
#include <framework/image.h>
#include <glm/gtx/string_cast.hpp>

glm::vec3 sampleTextureNearest(const Image& image, const glm::vec2& texCoord)
{
    glm::vec2 texture = glm::clamp(texCoord, glm::vec2(0), glm::vec2(1));
    int i = std::min(int(std::floor(texture.x * image.width)), image.width - 1);
    int j = std::min(int(std::floor(texture.y * image.height)), image.height - 1);
    return image.pixels[j * image.width + i];
}

glm::vec3 sampleTextureBilinear(const Image& image, const glm::vec2& texCoord)
{
    float x = std::clamp(texCoord.x * image.width - 0.5f, 0.f, image.width - 1.f);
    float y = std::clamp(texCoord.y * image.height - 0.5f, 0.f, image.height - 1.f);
    glm::vec2 lower = glm::vec2(floor(x), floor(y));
    glm::vec2 upper = glm::vec2(ceil(x), ceil(y));
    glm::vec3 c00 = image.pixels[image.width * lower.y + lower.x];
    glm::vec3 c10 = image.pixels[image.width * lower.y + upper.x];
    glm::vec3 c01 = image.pixels[image.width * upper.y + lower.x];
    glm::vec3 c11 = image.pixels[image.width * upper.y + upper.x];
    float fx = x - lower.x, fy = y - lower.y;
    return (c00 * (1 - fx) + c10 * fx) * (1 - fy) + (c01 * (1 - fx) + c11 * fx) * fy;
}
