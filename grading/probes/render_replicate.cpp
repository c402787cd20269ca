#include "grading/probes/render_replicate.h"
#include "bvh.h"
#include "files/feature_settings.h"
#include "files/scene_file.h"
#include "render.h"
#include "submission/paths.h"

namespace grading {
namespace {

    files::SceneFile load(const ReplicatesRequest& request)
    {
        files::SceneFile file
            = files::loadSceneFile(std::filesystem::path(submission::sourceDirectory) / request.scene);
        for (const Setting& setting : request.settings)
            files::setFeature(file.config.features, setting.name, setting.value);
        file.config.size = request.size;
        return file;
    }

}

std::vector<glm::vec3> tileMeans(std::span<const glm::vec3> pixels, glm::ivec2 size)
{
    const int perRow = size.x / finestTile;
    std::vector<glm::vec3> means(static_cast<std::size_t>(perRow * (size.y / finestTile)));
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            means[static_cast<std::size_t>(y / finestTile * perRow + x / finestTile)]
                += pixels[static_cast<std::size_t>(y * size.x + x)] / static_cast<float>(finestTile * finestTile);
    return means;
}

Replicates replicate(const ReplicatesRequest& request, const Shade& shade)
{
    const auto [scene, config] = load(request);
    const BVH bvh { scene, config.features };
    const Trackball camera = makeTrackball(config);
    const glm::ivec2 size = request.size;
    const auto numPixels = static_cast<uint32_t>(size.x * size.y);

    Replicates all { size, std::vector<glm::vec3>(numPixels), {} };
    for (const uint32_t seed : request.seeds) {
        std::vector<glm::vec3> pixels;
        pixels.reserve(numPixels);
        for (uint32_t i = 0; i < numPixels; ++i) {
            // An odd factor: distinct seeds stay distinct.
            RenderState state { scene, config.features, bvh, Sampler(seed * 0x9e3779b9u + i) };
            const glm::ivec2 pixel { static_cast<int>(i) % size.x, static_cast<int>(i) / size.x };
            const std::vector<Ray> rays = generatePixelRays(state, camera, pixel, size);
            pixels.push_back(shade(state, rays));
            all.mean[i] += pixels.back() / static_cast<float>(request.seeds.size());
        }
        all.tiles.push_back(tileMeans(pixels, size));
    }
    return all;
}

}
