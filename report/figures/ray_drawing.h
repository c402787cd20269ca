#pragma once
#include "report/studio.h"

namespace report {

inline const glm::vec3 yellow { 1.0f, 1.0f, 0.0f }, green { 0.0f, 1.0f, 0.0f }, red { 1.0f, 0.0f, 0.0f };

// Whether two colours would be called by one name.
[[nodiscard]] bool isLike(const glm::vec3& color, const glm::vec3& other);

// Of what was drawn on the path from the camera on, all that are such a Drawn.
template <typename Thing> [[nodiscard]] std::vector<Thing> drawnOf(const worker::DebugRay& ray)
{
    std::vector<Thing> things;
    for (const debug::Shape& shape : ray.shapes)
        if (const Thing* thing = std::get_if<Thing>(&shape.drawn); thing && shape.cause.way == debug::Way::Path)
            things.push_back(*thing);
    return things;
}

// The same ray, with only what stays true of `keep`.
template <typename Keep> [[nodiscard]] worker::DebugRay onlyDrawn(worker::DebugRay ray, const Keep& keep)
{
    std::erase_if(ray.shapes, [&](const debug::Shape& shape) { return !keep(shape); });
    return ray;
}

// What the ray was, so that ./raywork render --debug-ray follows it again.
[[nodiscard]] std::vector<Fact> factsOfRay(const worker::RenderRequest& request, glm::ivec2 pixel);

// A part of a drawing, as crop for pictures.
[[nodiscard]] Drawing crop(const Drawing& drawing, glm::ivec2 from, glm::ivec2 size);

}
