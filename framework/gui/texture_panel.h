#pragma once
#include "scene.h"
#include "worker/debug_ray.h"

namespace gui {

// A window with the textures that a ray looked up on its way, one lookup at a time: the texels around the place far
// magnified, those that took part with their weights, and where that is in the texture. Nothing when there are none.
class TexturePanel {
public:
    void show(const worker::DebugRay& ray, const Scene& scene);

private:
    void choose(const std::vector<worker::TextureLookup>& lookups);

    std::size_t m_lookup = 0; // which one is shown
};

}
