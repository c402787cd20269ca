#include "worker/integrand.h"
#include "sampler.h"
#include <numbers>

namespace worker {
namespace {

    // Within sqrt(2) of the point, which is all of its pixel, it covers what is on the left of the direction; beyond 2
    // it covers nothing.
    EdgePicture::Corners triangleWithEdge(const glm::dvec2& point, const glm::dvec2& direction)
    {
        const glm::dvec2 left(-direction.y, direction.x);
        return { point - 2.0 * direction, point + 2.0 * direction, point + 2.0 * left };
    }

}

EdgePicture edgePicture(Integrand integrand)
{
    EdgePicture picture;
    Sampler sampler(1);
    for (int tile = 0; tile < EdgePicture::numTiles * EdgePicture::numTiles; ++tile) {
        const glm::ivec2 corner(tile % EdgePicture::numTiles, tile / EdgePicture::numTiles);
        const glm::ivec2 pixel = EdgePicture::tileSide * corner + EdgePicture::tileSide / 2;
        const glm::dvec2 point = glm::dvec2(pixel) + glm::dvec2(sampler.next_2d());
        const double turns = static_cast<double>(sampler.next_1d());
        const double angle
            = 2.0 * std::numbers::pi * (integrand == Integrand::Edge ? turns : std::floor(4.0 * turns) / 4.0);
        picture.triangles.push_back(triangleWithEdge(point, { std::cos(angle), std::sin(angle) }));
        picture.pixels.push_back(pixel);
    }
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
