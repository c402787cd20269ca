#include "texture.h"

static glm::vec3 colorAt(const Image& image, glm::ivec2 texel)
{
    texel = glm::clamp(texel, glm::ivec2(0), glm::ivec2(image.width, image.height) - 1);
    return image.get_pixel<3>(texel.x + image.width * texel.y);
}

glm::vec3 sampleTextureNearest(const Image& image, const glm::vec2& texCoord)
{
    const glm::vec2 inside = glm::clamp(texCoord, glm::vec2(0.0f), glm::vec2(1.0f));
    return colorAt(image, glm::ivec2(inside * glm::vec2(image.width, image.height)));
}

glm::vec3 sampleTextureBilinear(const Image& image, const glm::vec2& texCoord)
{
    const glm::vec2 position = glm::clamp(texCoord, 0.0f, 1.0f) * glm::vec2(image.width, image.height) - 0.5f;
    const glm::ivec2 first = glm::ivec2(glm::floor(position));
    const glm::vec2 t = glm::fract(position);
    const glm::vec3 bottomLeft = colorAt(image, first);
    const glm::vec3 bottomRight = colorAt(image, first + glm::ivec2(1, 0));
    const glm::vec3 topLeft = colorAt(image, first + glm::ivec2(0, 1));
    const glm::vec3 topRight = colorAt(image, first + glm::ivec2(1, 1));
    return (1.0f - t.x) * (1.0f - t.y) * bottomLeft + t.x * (1.0f - t.y) * bottomRight + (1.0f - t.x) * t.y * topLeft
        + t.x * t.y * topRight;
}
