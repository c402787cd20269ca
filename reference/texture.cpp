#include "texture.h"

// Into [0, size - 1] while still a float: beyond the range of int the conversion would be undefined. NaN becomes 0.
static float clampToTexels(float x, int size)
{
    return std::min(std::max(0.0f, x), static_cast<float>(size - 1));
}

glm::vec3 sampleTextureNearest(const Image& image, const glm::vec2& texCoord)
{
    const int i
        = static_cast<int>(clampToTexels(std::floor(texCoord.x * static_cast<float>(image.width)), image.width));
    const int j
        = static_cast<int>(clampToTexels(std::floor(texCoord.y * static_cast<float>(image.height)), image.height));
    return image.get_pixel(j * image.width + i);
}

glm::vec3 sampleTextureBilinear(const Image& image, const glm::vec2& texCoord)
{
    // In units of texels from the centre of texel (0, 0). Clamped before the weights are taken, so that beyond the
    // outermost centres the edge's texel is all there is.
    const float x = clampToTexels(texCoord.x * static_cast<float>(image.width) - 0.5f, image.width);
    const float y = clampToTexels(texCoord.y * static_cast<float>(image.height) - 0.5f, image.height);
    const int i0 = static_cast<int>(x);
    const int j0 = static_cast<int>(y);
    const int i1 = std::min(i0 + 1, image.width - 1);
    const int j1 = std::min(j0 + 1, image.height - 1);

    const auto texel = [&](int i, int j) { return image.get_pixel(j * image.width + i); };
    const float fx = x - static_cast<float>(i0);
    const glm::vec3 lower = glm::mix(texel(i0, j0), texel(i1, j0), fx);
    const glm::vec3 upper = glm::mix(texel(i0, j1), texel(i1, j1), fx);
    return glm::mix(lower, upper, y - static_cast<float>(j0));
}
