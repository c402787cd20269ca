#include "report/figures/stage.h"
#include "intersect.h"
#include "submission/paths.h"
#include "worker/middle_ray.h"
#include <algorithm>

namespace report {

worker::RenderRequest figureScene(const std::string& name, glm::ivec2 size, std::vector<std::string> settings)
{
    worker::RenderRequest request;
    request.scene
        = (std::filesystem::path(submission::sourceDirectory) / "report" / "scenes" / (name + ".toml")).string();
    request.size = size;
    request.settings = std::move(settings);
    return request;
}

static Config configOf(Config config, const worker::RenderRequest& request)
{
    if (request.size != glm::ivec2(0))
        config.size = request.size;
    return config;
}

Stage::Stage(const worker::RenderRequest& request)
    : m_file(files::loadSceneFile(request.scene))
    , m_config(configOf(m_file.config, request))
    , m_camera(makeTrackball(m_config))
    , m_bvh(m_file.scene, m_config.features)
{
}

Ray Stage::rayThrough(glm::ivec2 pixel) const
{
    return worker::middleRay(m_camera, pixel, m_config.size);
}

std::optional<HitInfo> Stage::hitIn(glm::ivec2 pixel) const
{
    RenderState state { m_file.scene, m_config.features, m_bvh, Sampler(1) };
    Ray ray = rayThrough(pixel);
    HitInfo hitInfo;
    if (!intersectRayWithBVH(state, m_bvh, ray, hitInfo))
        return {};
    return hitInfo;
}

std::vector<std::optional<HitInfo>> Stage::hits() const
{
    std::vector<std::optional<HitInfo>> hits;
    for (int y = 0; y < m_config.size.y; ++y)
        for (int x = 0; x < m_config.size.x; ++x)
            hits.push_back(hitIn({ x, y }));
    return hits;
}

std::vector<Crossing> Stage::crossings(glm::ivec2 pixel) const
{
    std::vector<Crossing> crossings;
    for (const BVHInterface::Primitive& p : m_bvh.primitives()) {
        Ray ray = rayThrough(pixel); // at full length for each of them
        HitInfo unused;
        if (intersectRayWithTriangle(p.v0.position, p.v1.position, p.v2.position, ray, unused))
            crossings.push_back({ p, ray.t });
    }
    std::ranges::sort(crossings, {}, &Crossing::t);
    return crossings;
}

}
