#include "files/picture.h"
#include "files/error.h"
#include "files/texel_source.h"
#include "files/text.h"
#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <fstream>
#include <stb_image.h>
#include <string_view>

namespace files {
namespace {

    constexpr int maxSide = 8192; // texels: 200 MB at most, however small the file is
    constexpr int numChannels = 3; // no part of the framework reads an alpha channel

    // What stb reads from. It pads a file that ends early with zeros; pastEnd remembers that it had to.
    struct Source {
        std::string_view left;
        bool pastEnd = false;

        static int read(void* user, char* data, int size)
        {
            auto& source = *static_cast<Source*>(user);
            const std::size_t count = std::min(source.left.size(), static_cast<std::size_t>(size));
            source.pastEnd = source.pastEnd || count == 0;
            std::memcpy(data, source.left.data(), count);
            source.left.remove_prefix(count);
            return static_cast<int>(count);
        }

        static void skip(void* user, int size)
        {
            auto& source = *static_cast<Source*>(user);
            source.left.remove_prefix(std::min(source.left.size(), static_cast<std::size_t>(std::max(size, 0))));
        }

        static int eof(void* user) { return static_cast<Source*>(user)->left.empty(); }
    };

    constexpr stbi_io_callbacks callbacks { Source::read, Source::skip, Source::eof };

    bool hasTgaExtension(const std::filesystem::path& path)
    {
        std::string extension = path.extension().string();
        std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
        return extension == ".tga";
    }

    // TGA has no signature, but no other format that stb knows has these in its second and third byte.
    bool hasTgaHeader(std::string_view bytes)
    {
        constexpr std::string_view imageTypes = "\x01\x02\x03\x09\x0a\x0b";
        return bytes.size() > 2 && bytes[1] >= 0 && bytes[1] <= 1 && imageTypes.find(bytes[2]) != imageTypes.npos;
    }

    // Keeps stb from its decoders that read out of bounds or hang on broken files.
    bool hasKnownFormat(const std::filesystem::path& path, std::string_view bytes)
    {
        return bytes.starts_with("\x89PNG\r\n\x1a\n") || bytes.starts_with("\xff\xd8\xff") || bytes.starts_with("BM")
            || (hasTgaExtension(path) && hasTgaHeader(bytes));
    }

    // As much of a file as somebody asks for.
    struct FileSource {
        std::ifstream file;

        static int read(void* user, char* data, int size)
        {
            auto& file = static_cast<FileSource*>(user)->file;
            return static_cast<int>(file.read(data, size).gcount());
        }

        static void skip(void* user, int size) { static_cast<FileSource*>(user)->file.ignore(size); }
        static int eof(void* user) { return !static_cast<FileSource*>(user)->file; }

        static constexpr stbi_io_callbacks callbacks { read, skip, eof };
    };

    void checkFormat(const std::filesystem::path& path, std::string_view bytes)
    {
        if (!hasKnownFormat(path, bytes))
            throw Error(path, "found an unknown format, expected a PNG, JPEG, BMP or TGA picture");
    }

    void checkSize(const std::filesystem::path& path, glm::ivec2 size)
    {
        if (size.x < 1 || size.y < 1 || size.x > maxSide || size.y > maxSide)
            throw Error(path,
                "found " + std::to_string(size.x) + "x" + std::to_string(size.y) + " texels, expected 1 to "
                    + std::to_string(maxSide) + " each way");
    }

    glm::ivec2 readSize(const std::filesystem::path& path)
    {
        FileSource source { openToRead(path) };
        std::array<char, 16> start {};
        const auto length = static_cast<std::size_t>(source.file.read(start.data(), start.size()).gcount());
        checkFormat(path, { start.data(), length });
        source.file.clear();
        source.file.seekg(0);
        glm::ivec2 size { 0 };
        int channels = 0;
        if (!stbi_info_from_callbacks(&FileSource::callbacks, &source, &size.x, &size.y, &channels))
            throw Error(path, std::string("found a broken picture: ") + stbi_failure_reason());
        checkSize(path, size);
        return size;
    }

    using Decoded = std::unique_ptr<stbi_uc, decltype(&stbi_image_free)>;

    Decoded decode(const std::filesystem::path& path, std::string_view bytes, int& width, int& height)
    {
        Source source { bytes };
        int channelsInFile = 0;
        Decoded texels { stbi_load_from_callbacks(&callbacks, &source, &width, &height, &channelsInFile, numChannels),
            stbi_image_free };
        if (!texels)
            throw Error(path, std::string("found a broken picture: ") + stbi_failure_reason());
        if (source.pastEnd)
            throw Error(path, "found the end of the file within the picture, expected a whole one");
        return texels;
    }

    // The bottom row first, as readSize said it is.
    std::vector<uint8_t> readTexels(const std::filesystem::path& path, glm::ivec2 size)
    {
        const std::string bytes = readText(path);
        checkFormat(path, bytes);
        glm::ivec2 found { 0 };
        const Decoded texels = decode(path, bytes, found.x, found.y);
        if (found != size)
            throw Error(path, "found a picture of another size than before");
        const auto rowSize = static_cast<std::size_t>(size.x) * numChannels;
        const auto numRows = static_cast<std::size_t>(size.y);
        std::vector<uint8_t> result(numRows * rowSize);
        for (std::size_t y = 0; y < numRows; ++y) // stb has the top row first
            std::memcpy(&result[(numRows - 1 - y) * rowSize], texels.get() + y * rowSize, rowSize);
        return result;
    }

}

std::shared_ptr<const Image> openPicture(const std::filesystem::path& path)
{
    const glm::ivec2 size = readSize(path);
    auto source = std::make_shared<files::TexelSource>();
    source->read = [path, size] { return readTexels(path, size); };
    return std::make_shared<Image>(size.x, size.y, numChannels, std::move(source));
}

std::shared_ptr<const Image> loadPicture(const std::filesystem::path& path)
{
    auto image = openPicture(path);
    (void)image->get_data();
    return image;
}

}
