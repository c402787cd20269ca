#include "report/figures/ray_drawing.h"
#include "report/pictures.h"
#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace report {

bool isLike(const glm::vec3& color, const glm::vec3& other)
{
    constexpr float tolerance = 0.1f; // less than a fifth of the way from one of our colours to the next
    return glm::distance(color, other) < tolerance;
}

std::vector<Fact> factsOfRay(const worker::RenderRequest& request, glm::ivec2 pixel)
{
    std::vector<Fact> facts = factsOf(request);
    facts.push_back({ "ray through pixel", fmt::format("{},{}", pixel.x, pixel.y) });
    facts.push_back({ "its seed", "1" }); // followRay's
    if (request.orbit != glm::vec2(0.0f))
        facts.push_back({ "orbit", fmt::format("{},{}", request.orbit.x, request.orbit.y) });
    return facts;
}

Drawing crop(const Drawing& drawing, glm::ivec2 from, glm::ivec2 size)
{
    Drawing part { crop(drawing.picture, from, size), drawing.strokes };
    for (debug::Stroke& stroke : part.strokes)
        for (glm::vec2& point : stroke.points)
            point -= glm::vec2(from);
    return part;
}

}
