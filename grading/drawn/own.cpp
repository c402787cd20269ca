#include "grading/drawn/own.h"
#include "grading/drawn/near.h"

namespace grading {
namespace {

    using Shapes = std::span<const debug::Shape>;

    constexpr glm::vec3 red { 1.0f, 0.0f, 0.0f };
    constexpr glm::vec3 white { 1.0f };

    template <typename Kind> const Kind* first(Shapes shapes)
    {
        return shapes.empty() ? nullptr : std::get_if<Kind>(&shapes.front().drawn);
    }

    struct Path {
        std::span<const debug::Hit> hits;
        std::span<const debug::Hit> recorded;
    };

    // What renderRay draws: white up to a hit, red where there is none.
    std::size_t countRayOfPath(Shapes shapes, const Path& path)
    {
        const auto* const drawn = first<debug::DrawnRay>(shapes);
        if (!drawn)
            return 0;
        const auto isDrawn = [&](const debug::Hit& hit) {
            return isNear(hit.ray.origin, drawn->ray.origin) && isNear(endOf(hit.ray), endOf(drawn->ray));
        };
        if (drawn->color == white)
            return std::ranges::any_of(path.hits, isDrawn);
        const int bounce = shapes.front().cause.bounce;
        const bool hasHit
            = std::ranges::any_of(path.recorded, [&](const debug::Hit& hit) { return hit.cause.bounce == bounce; });
        const bool startsAtCamera = !path.hits.empty() && isNear(path.hits.front().ray.origin, drawn->ray.origin);
        return drawn->color == red && !hasHit && (bounce > 0 || startsAtCamera);
    }

    // What visibilityOfLightSample draws: a ray to a light's sample, and the sample.
    std::size_t countShadowRay(Shapes shapes)
    {
        const auto* const ray = first<debug::DrawnRay>(shapes);
        const auto* const sample = ray ? first<debug::DrawnSphere>(shapes.subspan(1)) : nullptr;
        const bool isShadowRay = sample && shapes[0].cause.way == debug::Way::Shadow && ray->ray.t == 1.0f
            && sample->radius == 0.02f && isNear(endOf(ray->ray), sample->center);
        return isShadowRay ? 2 : 0;
    }

    // What the reference's light.cpp draws: a red ray before each of those.
    std::size_t countRayToLight(Shapes shapes)
    {
        const auto* const ray = first<debug::DrawnRay>(shapes);
        if (!ray || ray->color != red || countShadowRay(shapes.subspan(1)) == 0)
            return 0;
        const Ray& shadow = first<debug::DrawnRay>(shapes.subspan(1))->ray;
        return isNear(ray->ray.origin, shadow.origin) && isNear(endOf(ray->ray), endOf(shadow)) ? 3 : 0;
    }

    // What the reference's bvh.cpp draws: boxes, each with a sphere where the ray enters, and a triangle if one is hit.
    std::size_t countTraversal(Shapes shapes)
    {
        std::size_t count = 0;
        for (;; count += 2) {
            const auto* const box = first<debug::DrawnBox>(shapes.subspan(count));
            const auto* const entry = box ? first<debug::DrawnSphere>(shapes.subspan(count + 1)) : nullptr;
            if (!entry || entry->radius != 0.005f || entry->color != box->color)
                break;
        }
        return count > 0 && first<debug::DrawnTriangle>(shapes.subspan(count)) ? count + 1 : count;
    }

    // How many of the first shapes belong together and are not the submission's; 0 if the first may be.
    std::size_t countOfOthers(const std::string& file, Shapes shapes, const Path& path)
    {
        std::size_t count = countRayOfPath(shapes, path);
        if (count == 0)
            count = countShadowRay(shapes);
        if (count == 0 && file != "light")
            count = countRayToLight(shapes);
        if (count == 0 && file != "bvh")
            count = countTraversal(shapes);
        return count;
    }

}

std::vector<debug::Drawn> drawnByFile(const std::string& file, std::span<const debug::Shape> shapes,
    std::span<const debug::Hit> hits, std::span<const debug::Hit> recorded)
{
    std::vector<debug::Drawn> own;
    while (!shapes.empty()) {
        const std::size_t others = countOfOthers(file, shapes, { hits, recorded });
        if (others == 0)
            own.push_back(shapes.front().drawn);
        shapes = shapes.subspan(std::max<std::size_t>(others, 1));
    }
    return own;
}

}
