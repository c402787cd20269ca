#include "worker/integrand.h"

namespace worker {
namespace {

    // On which side of the line, and how far.
    double heightOver(const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& p)
    {
        return ((to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x)) / glm::length(to - from);
    }

    // Whether the first edge passes between the corners of the pixel, and the others stay away.
    bool isOnFirstEdge(const std::vector<glm::dvec2>& corners, const glm::ivec2& pixel)
    {
        int numInside = 0;
        for (const glm::ivec2 offset : { glm::ivec2(0, 0), glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(1, 1) }) {
            const glm::dvec2 p(pixel + offset);
            if (heightOver(corners[1], corners[2], p) <= 0.0 || heightOver(corners[2], corners[0], p) <= 0.0)
                return false;
            numInside += heightOver(corners[0], corners[1], p) > 0.0;
        }
        return numInside > 0 && numInside < 4;
    }

}

EdgePicture edgePicture(Integrand integrand)
{
    EdgePicture picture;
    picture.corners = integrand == Integrand::Edge
        ? std::vector<glm::dvec2> { { -20.3, -5.2 }, { 40.1, 24.9 }, { -10.0, 60.0 } }
        : std::vector<glm::dvec2> { { -30.0, 7.37 }, { 46.0, 7.37 }, { 8.0, 60.0 } }; // between two lines of any grid
    for (int y = 0; y < EdgePicture::side; ++y)
        for (int x = 0; x < EdgePicture::side; ++x)
            if (isOnFirstEdge(picture.corners, { x, y }))
                picture.pixels.emplace_back(x, y);
    return picture;
}

LitFloor litFloor(Integrand integrand)
{
    const glm::vec3 white(1.0f);
    LitFloor floor { { { -100, 200, -100 }, { 200, 0, 0 }, { 0, 0, 200 }, white, white, white, white }, {}, {} };
    if (integrand == Integrand::SoftShadow) // its first edge alone crosses the light
        floor.blocker = { { -170, 100, -70 }, { 130, 110, 50 }, { -100, 100, 900 } };
    for (int i = 0; i < 16; ++i)
        floor.points.emplace_back(5.0f * static_cast<float>(i % 4), 0.0f, 5.0f * static_cast<float>(i / 4));
    return floor;
}

}
