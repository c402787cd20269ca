#include "worker/load_request.h"
#include "files/feature_settings.h"
#include "worker/progress_reporter.h"
#include <malloc.h>
#include <optional>
#include <stdexcept>

namespace worker {

// "name=value"
static void apply(const std::string& setting, Features& features)
{
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos)
        throw std::invalid_argument("found the setting '" + setting + "', expected feature=value");
    files::setFeature(features, setting.substr(0, equals), setting.substr(equals + 1));
}

static files::SceneFile loadFile(const RenderRequest& request, const std::function<void(float)>& onProgress)
{
    values::Progress progress;
    std::optional<ProgressReporter> reporter;
    if (request.wantsProgress && onProgress)
        reporter.emplace([&] { return progress.fraction(); }, onProgress);
    return files::loadSceneFile(request.scene, progress);
}

files::SceneFile load(const RenderRequest& request, const std::function<void(float)>& onProgress)
{
    files::SceneFile file = loadFile(request, onProgress);
    malloc_trim(0); // what a large file took while it was read is for the tree
    for (const std::string& setting : request.settings)
        apply(setting, file.config.features);
    if (request.size != glm::ivec2(0))
        file.config.size = request.size;
    return file;
}

Trackball cameraOf(Config config, const RenderRequest& request)
{
    config.camera.rotation += glm::vec3(request.orbit, 0.0f);
    return makeTrackball(config);
}

}
