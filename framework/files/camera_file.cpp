#include "files/camera_file.h"
#include "files/scene_config.h"
#include "files/scene_tables.h"
#include "files/text.h"
#include "files/write_readable.h"

namespace files {

static CameraConfig cameraOf(const std::filesystem::path& path, const TomlValue& document)
{
    TableReader top(path, document);
    if (top.find("camera") == nullptr)
        top.fail(1, "found no [camera], expected one");
    CameraConfig camera;
    readCamera(top, camera);
    return camera;
}

void saveCamera(const std::filesystem::path& to, const CameraConfig& camera)
{
    writeReadable(to, { cameraEntry(camera) }, [&](const TomlValue& document) { (void)cameraOf(to, document); });
}

CameraConfig loadCamera(const std::filesystem::path& path)
{
    return cameraOf(path, loadToml(path));
}

bool isCameraFile(const std::filesystem::path& path)
{
    if (lowerExtension(path) != ".toml")
        return false;
    const TomlValue document = loadToml(path);
    const auto& entries = std::get<TomlValue::Table>(document.content);
    return entries.size() == 1 && entries.front().key == "camera";
}

}
