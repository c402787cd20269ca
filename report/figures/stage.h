#pragma once
#include "bvh.h"
#include "files/scene_file.h"
#include "worker/render_request.h"
#include <framework/trackball.h>
#include <optional>
#include <string>
#include <vector>

namespace report {

// A scene of report/scenes, which only figures show; see sceneNamed.
[[nodiscard]] worker::RenderRequest figureScene(
    const std::string& name, glm::ivec2 size, std::vector<std::string> settings = {});

// A triangle in a ray's way.
struct Crossing {
    BVHInterface::Primitive primitive;
    float t;
};

// A request's scene in this process, seen by the library's own traversal: what pictures of it must agree with, whoever
// made them.
class Stage {
public:
    explicit Stage(const worker::RenderRequest& request);
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    [[nodiscard]] const Scene& scene() const { return m_file.scene; }

    // What the ray through the pixel's middle meets; empty if nothing.
    [[nodiscard]] std::optional<HitInfo> hitIn(glm::ivec2 pixel) const;

    // Of all pixels, row 0 at the bottom.
    [[nodiscard]] std::vector<std::optional<HitInfo>> hits() const;

    // All triangles in that ray's way, the nearest first.
    [[nodiscard]] std::vector<Crossing> crossings(glm::ivec2 pixel) const;

private:
    [[nodiscard]] Ray rayThrough(glm::ivec2 pixel) const;

    files::SceneFile m_file;
    Config m_config;
    Trackball m_camera;
    BVH m_bvh;
};

}
