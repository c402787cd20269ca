#include "files/texel_source.h"
#include <framework/image.h>

Texels::Texels(std::size_t count, int channels)
    : m_count(count)
    , m_channels(channels)
    , m_bytes(count * static_cast<std::size_t>(channels))
    , m_data(m_bytes.data())
{
}

Texels::Texels(std::size_t count, int channels, std::shared_ptr<files::TexelSource> source)
    : m_count(count)
    , m_channels(channels)
    , m_source(std::move(source))
{
}

Texels::Texels(const Texels& other)
    : m_count(other.m_count)
    , m_channels(other.m_channels)
{
    if (m_count == 0)
        return;
    (void)other.data();
    m_bytes = other.m_bytes;
    m_data = m_bytes.data();
}

Texels::Texels(Texels&& other) noexcept
    : m_count(std::exchange(other.m_count, 0))
    , m_channels(other.m_channels)
    , m_source(std::move(other.m_source))
    , m_bytes(std::move(other.m_bytes))
    , m_data(other.m_data.exchange(nullptr))
{
}

Texels& Texels::operator=(Texels other) noexcept
{
    std::swap(m_count, other.m_count);
    std::swap(m_channels, other.m_channels);
    std::swap(m_source, other.m_source);
    std::swap(m_bytes, other.m_bytes);
    m_data = other.m_data.exchange(m_data);
    return *this;
}

const uint8_t* Texels::fetch() const
{
    if (!m_source)
        return nullptr;
    const std::lock_guard lock(m_source->mutex);
    if (!areFetched()) {
        m_bytes = m_source->read();
        m_data.store(m_bytes.data(), std::memory_order_release);
    }
    return m_data;
}

glm::vec3 Texels::operator[](std::size_t index) const
{
    const uint8_t* texel = data() + index * static_cast<std::size_t>(m_channels);
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

Image::Image(int width_, int height_, int channels_, std::shared_ptr<files::TexelSource> source)
    : width(width_)
    , height(height_)
    , channels(channels_)
    , pixels(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), channels_, std::move(source))
{
}
