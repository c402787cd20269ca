#include "files/bitmap.h"
#include "files/error.h"
#include <framework/image.h>
#include <fstream>
#include <glm/common.hpp>
#include <new>
#include <stb_image_write.h>

namespace files {
namespace {

    void writeTo(void* stream, void* data, int size)
    {
        static_cast<std::ofstream*>(stream)->write(static_cast<const char*>(data), size);
    }

    void appendTo(void* bytes, void* data, int size)
    {
        const auto* const first = static_cast<const std::byte*>(data);
        auto& all = *static_cast<std::vector<std::byte>*>(bytes);
        all.insert(all.end(), first, first + size);
    }

    // 8 bits a channel with the top row first, as stb takes them.
    Image quantised(glm::ivec2 resolution, std::span<const glm::vec3> pixels)
    {
        Image image(resolution.x, resolution.y);
        for (int y = 0; y < resolution.y; ++y)
            for (int x = 0; x < resolution.x; ++x) {
                const glm::vec3& color = pixels[static_cast<std::size_t>(y * resolution.x + x)];
                // In this order max turns NaN, which has no 8-bit value, into 0.
                image.set_pixel((resolution.y - 1 - y) * resolution.x + x, glm::max(glm::vec3(0.0f), color));
            }
        return image;
    }

}

void saveBitmap(const std::filesystem::path& path, glm::ivec2 resolution, std::span<const glm::vec3> pixels)
{
    const Image image = quantised(resolution, pixels);
    std::ofstream stream(path, std::ios::binary);
    const bool written
        = stbi_write_bmp_to_func(writeTo, &stream, image.width, image.height, image.channels, image.get_data());
    stream.close();
    if (!written || !stream)
        throw Error(path, "cannot be written");
}

std::vector<std::byte> encodePng(glm::ivec2 resolution, std::span<const glm::vec3> pixels)
{
    const Image image = quantised(resolution, pixels);
    std::vector<std::byte> bytes;
    const int rowBytes = image.width * image.channels;
    if (!stbi_write_png_to_func(
            appendTo, &bytes, image.width, image.height, image.channels, image.get_data(), rowBytes))
        throw std::bad_alloc(); // there is no other reason
    return bytes;
}

}
