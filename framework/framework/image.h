#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <utility>
#include <vector>

namespace files {
struct TexelSource;
}

// The texels of an image as bytes; indexing reads one as a colour in [0, 1], as the 2023-24 edition does. They may come
// from a source, which is asked when somebody first looks at them, from whatever thread; a copy has looked.
class Texels {
public:
    Texels() = default;
    Texels(std::size_t count, int channels);
    Texels(std::size_t count, int channels, std::shared_ptr<files::TexelSource> source);
    Texels(const Texels& other);
    Texels(Texels&& other) noexcept;
    Texels& operator=(Texels other) noexcept;

    [[nodiscard]] std::size_t size() const { return m_count; }
    [[nodiscard]] glm::vec3 operator[](std::size_t index) const;
    [[nodiscard]] uint8_t* data() { return const_cast<uint8_t*>(std::as_const(*this).data()); }
    [[nodiscard]] const uint8_t* data() const
    {
        const uint8_t* const bytes = m_data.load(std::memory_order_acquire);
        return bytes ? bytes : fetch();
    }

    // Whether they are there already.
    [[nodiscard]] bool areFetched() const { return m_data.load(std::memory_order_acquire) != nullptr; }

private:
    const uint8_t* fetch() const;

    std::size_t m_count = 0;
    int m_channels = 3;
    std::shared_ptr<files::TexelSource> m_source; // null if there never was one
    mutable std::vector<uint8_t> m_bytes;
    mutable std::atomic<const uint8_t*> m_data = nullptr; // the bytes, once they are there
};

// An 8-bit picture. Texel (i, j) has index j * width + i; row 0 is the row that v = 0 addresses.
struct Image {
    int width = 0, height = 0, channels = 3;
    Texels pixels;

    Image() = default;
    Image(int width, int height, int channels = 3);
    Image(int width, int height, int channels, std::shared_ptr<files::TexelSource> source);

    // Colour of a texel, each channel in [0, 1]; channels that the image lacks repeat its last one.
    template <int N = 3> [[nodiscard]] glm::vec<N, float> get_pixel(int index) const
    {
        const uint8_t* texel = pixels.data() + static_cast<std::ptrdiff_t>(index) * channels;
        glm::vec<N, float> color;
        for (int c = 0; c < N; ++c)
            color[c] = static_cast<float>(texel[std::min(c, channels - 1)]) / 255.0f;
        return color;
    }

    // Stores a colour, each channel clamped to [0, 1] and rounded to the nearest of 256 steps.
    template <int N = 3> void set_pixel(int index, glm::vec<N, float> color)
    {
        uint8_t* texel = pixels.data() + static_cast<std::ptrdiff_t>(index) * channels;
        for (int c = 0; c < std::min(N, channels); ++c)
            texel[c] = static_cast<uint8_t>(std::clamp(color[c], 0.0f, 1.0f) * 255.0f + 0.5f);
    }

    [[nodiscard]] uint8_t* get_data() { return pixels.data(); }
    [[nodiscard]] const uint8_t* get_data() const { return pixels.data(); }
};
