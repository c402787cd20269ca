#include "texture.h"

static int clampIndex(double index, int size)
{
    return static_cast<int>(std::clamp(index, 0.0, size - 1.0));
}

glm::vec3 sampleTextureNearest(const Image& image, const glm::vec2& texCoord)
{
    const int column = clampIndex(static_cast<double>(texCoord.x) * image.width, image.width);
    const int row = clampIndex(static_cast<double>(texCoord.y) * image.height, image.height);
    return image.get_pixel(row * image.width + column);
}

// How much of texel k lies in [start, start + 1].
static double overlap(double start, double k)
{
    return std::max(0.0, std::min(start, k) + 1.0 - std::max(start, k));
}

glm::vec3 sampleTextureBilinear(const Image& image, const glm::vec2& texCoord)
{
    const double left = static_cast<double>(texCoord.x) * image.width - 0.5;
    const double bottom = static_cast<double>(texCoord.y) * image.height - 0.5;
    glm::dvec3 color(0.0);
    for (double y = std::floor(bottom) - 1.0; y < bottom + 2.0; ++y) {
        for (double x = std::floor(left) - 1.0; x < left + 2.0; ++x) {
            const int texel = clampIndex(y, image.height) * image.width + clampIndex(x, image.width);
            color += overlap(left, x) * overlap(bottom, y) * glm::dvec3(image.get_pixel(texel));
        }
    }
    return glm::vec3(color);
}
