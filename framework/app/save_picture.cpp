#include "app/save_picture.h"
#include "files/error.h"
#include <OpenImageIO/imageio.h>
#include <memory>

namespace app {

namespace fs = std::filesystem;

void checkPictureName(const fs::path& path)
{
    if (path.extension() != ".png" && path.extension() != ".exr")
        throw files::Error(path, "found a picture of type '" + path.extension().string() + "', expected .png or .exr");
}

void savePicture(const fs::path& path, glm::ivec2 size, std::span<const glm::vec3> pixels)
{
    checkPictureName(path);
    const fs::path unfinished = path.parent_path() / (".unfinished-" + path.filename().string());
    const auto output = OIIO::ImageOutput::create(unfinished.string());
    const auto type = path.extension() == ".exr" ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8;
    const OIIO::ImageSpec spec(size.x, size.y, 3, type);
    constexpr auto pixelBytes = static_cast<OIIO::stride_t>(sizeof(glm::vec3));
    const glm::vec3* topRow = pixels.data() + pixels.size() - static_cast<std::size_t>(size.x);
    const bool written = output && output->open(unfinished.string(), spec)
        && output->write_image(OIIO::TypeDesc::FLOAT, topRow, pixelBytes, -pixelBytes * size.x) && output->close();
    std::error_code failed;
    if (written)
        fs::rename(unfinished, path, failed);
    if (!written || failed) {
        const std::string why = failed ? failed.message() : output ? output->geterror() : OIIO::geterror();
        fs::remove(unfinished, failed);
        throw files::Error(path, "cannot be written: " + why);
    }
}

}
