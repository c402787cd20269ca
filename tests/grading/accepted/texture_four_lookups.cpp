#include "texture.h"

glm::vec3 sampleTextureNearest(const Image& image, const glm::vec2& texCoord)
{
    int x = static_cast<int>(std::floor(texCoord.x * image.width));
    int y = static_cast<int>(std::floor(texCoord.y * image.height));
    if (x < 0)
        x = 0;
    if (x >= image.width)
        x = image.width - 1;
    if (y < 0)
        y = 0;
    if (y >= image.height)
        y = image.height - 1;
    return image.get_pixel(y * image.width + x);
}

glm::vec3 sampleTextureBilinear(const Image& image, const glm::vec2& texCoord)
{
    // Looking up centres of texels is safe from rounding.
    const glm::vec2 size(image.width, image.height);
    const glm::vec2 corner = glm::floor(texCoord * size - 0.5f) + 0.5f;
    const glm::vec2 weight = texCoord * size - corner;

    glm::vec3 color(0.0f);
    for (int dx = 0; dx < 2; ++dx) {
        for (int dy = 0; dy < 2; ++dy) {
            const glm::vec2 centre = corner + glm::vec2(dx, dy);
            const float wx = dx == 1 ? weight.x : 1.0f - weight.x;
            const float wy = dy == 1 ? weight.y : 1.0f - weight.y;
            color += wx * wy * sampleTextureNearest(image, centre / size);
        }
    }
    return color;
}
