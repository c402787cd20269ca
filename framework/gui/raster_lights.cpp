#include "gui/raster_lights.h"

namespace gui {
namespace {

    PointLight asPoint(const PointLight& light)
    {
        return light;
    }

    PointLight asPoint(const SegmentLight& light)
    {
        return { 0.5f * (light.endpoint0 + light.endpoint1), 0.5f * (light.color0 + light.color1) };
    }

    PointLight asPoint(const ParallelogramLight& light)
    {
        return { light.v0 + 0.5f * (light.edge01 + light.edge02),
            0.25f * (light.color0 + light.color1 + light.color2 + light.color3) };
    }

}

std::vector<PointLight> rasterLights(const worker::View& view)
{
    if (view.lights.empty())
        return { { view.camera.position(), glm::vec3(1.0f) } };
    std::vector<PointLight> points;
    for (const Scene::SceneLight& light : view.lights)
        points.push_back(std::visit([](const auto& l) { return asPoint(l); }, light));
    return points;
}

}
