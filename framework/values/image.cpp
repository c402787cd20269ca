#include <framework/image.h>

Texels::Texels(std::size_t count, int channels)
    : m_channels(channels)
    , m_bytes(count * static_cast<std::size_t>(channels))
{
}

glm::vec3 Texels::operator[](std::size_t index) const
{
    const uint8_t* texel = m_bytes.data() + index * static_cast<std::size_t>(m_channels);
    glm::vec3 color;
    for (int c = 0; c < 3; ++c)
        color[c] = static_cast<float>(texel[std::min(c, m_channels - 1)]) / 255.0f;
    return color;
}

Image::Image(int width_, int height_, int channels_)
    : width(width_)
    , height(height_)
    , channels(channels_)
    , pixels(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), channels_)
{
}
