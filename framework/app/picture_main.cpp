// Writes the picture that comes in on stdin: width and height as ints, then the pixels as floats, bottom row first.
#include <OpenImageIO/imageio.h>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace fs = std::filesystem;

static std::string save(const fs::path& path, int width, int height, const std::vector<float>& pixels)
{
    const fs::path unfinished = path.parent_path() / (".unfinished-" + path.filename().string());
    const auto output = OIIO::ImageOutput::create(unfinished.string());
    if (!output)
        return OIIO::geterror();
    const auto type = path.extension() == ".exr" ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
    constexpr auto pixelBytes = static_cast<OIIO::stride_t>(3 * sizeof(float));
    const float* topRow = pixels.data() + pixels.size() - 3 * static_cast<std::size_t>(width);
    const bool written = output->open(unfinished.string(), OIIO::ImageSpec(width, height, 3, type))
        && output->write_image(OIIO::TypeDesc::FLOAT, topRow, pixelBytes, -pixelBytes * width) && output->close();
    std::error_code failed;
    if (written)
        fs::rename(unfinished, path, failed);
    if (written && !failed)
        return "";
    std::error_code ignored;
    fs::remove(unfinished, ignored);
    return failed ? failed.message() : output->geterror();
}

int main(int argc, char** argv)
{
    int size[2];
    if (argc != 2 || std::fread(size, sizeof(size), 1, stdin) != 1)
        return 1; // whoever renders has failed, and says so
    std::vector<float> pixels(3 * static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]));
    if (std::fread(pixels.data(), sizeof(float), pixels.size(), stdin) != pixels.size())
        return 1;
    const std::string error = save(argv[1], size[0], size[1], pixels);
    if (error.empty())
        return 0;
    std::fprintf(stderr, "%s: cannot be written: %s\n", argv[1], error.c_str());
    return 1;
}
