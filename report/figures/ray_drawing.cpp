#include "report/figures/ray_drawing.h"
#include "report/pictures.h"
#include <glm/geometric.hpp>

namespace report {

bool isLike(const glm::vec3& color, const glm::vec3& other)
{
    constexpr float tolerance = 0.1f; // less than a fifth of the way from one of our colours to the next
    return glm::distance(color, other) < tolerance;
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
