#include "app/save_debug_ray.h"
#include "app/debug_ray_json.h"
#include "app/save_picture.h"
#include "debug/raster.h"
#include "debug/svg.h"
#include "files/bitmap.h"
#include "files/error.h"
#include <fstream>

namespace app {
namespace {

    namespace fs = std::filesystem;

    bool isText(const fs::path& path)
    {
        return path.extension() == ".svg" || path.extension() == ".json";
    }

    void write(const fs::path& path, const std::string& text)
    {
        std::ofstream file(path, std::ios::binary);
        file << text;
        file.close();
        if (!file)
            throw files::Error(path, "cannot be written");
    }

}

void checkDebugRayName(const fs::path& path)
{
    if (!isText(path))
        checkPictureName(path);
}

void saveDebugRay(const fs::path& path, const worker::DebugRay& ray, const worker::Rendering& picture)
{
    if (path.extension() == ".json")
        return write(path, toJson(ray));
    const std::vector<debug::Stroke> strokes = strokesOf(ray.shapes, debug::Projection(ray.camera, ray.size));
    std::vector<glm::vec3> pixels = picture.pixels;
    for (glm::vec3& pixel : pixels) // so that what is drawn stands out
        pixel *= 0.5f;
    if (path.extension() == ".svg")
        return write(path, toSvg(strokes, ray.size, files::encodePng(ray.size, pixels)));
    debug::drawOver(pixels, ray.size, strokes);
    savePicture(path, ray.size, pixels);
}

}
