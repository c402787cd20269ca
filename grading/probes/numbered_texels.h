#pragma once
#include <cstdint>
#include <framework/image.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace grading {

// A picture in which neighbours have other colours, so that a wrong texel shows, whichever it is. There may be millions
// of them: a worker is told how to make it.
struct NumberedTexels {
    glm::ivec2 size { 0 };
    glm::ivec3 start { 0 }; // colour of the first texel, in [0, 255]
    int channels = 3; // 1 or 3
};

// 8-bit colour of the texel with that index in the image.
inline glm::ivec3 colorOf(const NumberedTexels& texels, int index)
{
    const glm::ivec3 color = texels.start + index % 256 * glm::ivec3(37, 91, 151); // odd: 256 texels before one repeats
    return (texels.channels == 1 ? glm::ivec3(color.x) : color) % 256;
}

inline Image toImage(const NumberedTexels& texels)
{
    Image image(texels.size.x, texels.size.y, texels.channels);
    uint8_t* byte = image.get_data();
    for (int i = 0; i < image.width * image.height; ++i)
        for (int c = 0; c < image.channels; ++c)
            *byte++ = static_cast<uint8_t>(colorOf(texels, i)[c]);
    return image;
}

}
