#include "grading/drawn/place.h"
#include "grading/drawn/closest.h"
#include "grading/drawn/near.h"
#include <fmt/format.h>
#include <framework/variant_helper.h>

namespace grading {
namespace {

    using Hits = std::span<const debug::Hit>;

    const debug::Hit* hitAt(const glm::vec3& point, Hits hits)
    {
        const auto found
            = std::ranges::find_if(hits, [&](const debug::Hit& hit) { return isNear(point, endOf(hit.ray)); });
        return found == hits.end() ? nullptr : &*found;
    }

    bool isAtLight(const glm::vec3& point, const Surroundings& around)
    {
        return std::ranges::any_of(
            around.lights, [&](const auto& light) { return isNear(point, closestOnLight(light, point)); });
    }

    std::string placeFrom(const debug::Hit& hit, const Ray& ray, const Surroundings& around)
    {
        const glm::vec3& normal = hit.hitInfo.normal;
        const glm::vec3 in = glm::normalize(hit.ray.direction);
        if (isAtLight(endOf(ray), around))
            return toALight;
        if (isAlong(ray.direction, normal))
            return "along the normal";
        if (isAlong(ray.direction, glm::reflect(in, normal)))
            return "in the mirrored direction";
        if (isAlong(ray.direction, in))
            return "on through the surface";
        if (isAlong(ray.direction, -normal))
            return "against the normal";
        if (isAlong(ray.direction, -in))
            return "back to where the ray came from";
        if (std::ranges::any_of(around.lights, [&](const auto& light) { return pointsAt(ray, light); }))
            return "towards a light";
        return "from a surface in another direction";
    }

    std::string placeOfRay(const Ray& ray, const Surroundings& around)
    {
        if (const debug::Hit* const hit = hitAt(ray.origin, around.hits))
            return placeFrom(*hit, ray, around);
        if (!hitAt(endOf(ray), around.hits))
            return "elsewhere";
        return isAtLight(ray.origin, around) ? "from a light to a surface" : "up to a surface";
    }

    bool isOnPath(const glm::vec3& point, Hits hits)
    {
        return std::ranges::any_of(hits, [&](const debug::Hit& hit) {
            const float along = glm::dot(point - hit.ray.origin, glm::normalize(hit.ray.direction));
            return isNear(point, hit.ray.origin + along * glm::normalize(hit.ray.direction));
        });
    }

    // Where a ray enters or leaves it.
    bool isOnBox(const glm::vec3& point, const debug::Drawn& shape)
    {
        const auto* const drawn = std::get_if<debug::DrawnBox>(&shape);
        if (!drawn)
            return false;
        const auto& [lower, upper] = drawn->box;
        const glm::vec3 inside = glm::min(point - lower, upper - point);
        constexpr float rounding = 1e-4f; // of coordinates in scenes of unit size
        return std::abs(std::min({ inside.x, inside.y, inside.z })) <= rounding;
    }

    std::string placeOfSphere(const debug::DrawnSphere& sphere, const Surroundings& around)
    {
        if (std::ranges::any_of(around.drawing, [&](const auto& shape) { return isOnBox(sphere.center, shape); }))
            return "on a box";
        if (hitAt(sphere.center, around.hits))
            return "at a surface";
        if (isAtLight(sphere.center, around))
            return "at a light";
        return isOnPath(sphere.center, around.hits) ? "on the ray" : "elsewhere";
    }

    // A point of a triangle divides it into three that have its area.
    bool contains(const debug::DrawnTriangle& triangle, const glm::vec3& point)
    {
        const auto area = [](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
            return glm::length(glm::cross(b - a, c - a));
        };
        const auto& [a, b, c] = triangle;
        const float parts = area(a.position, b.position, point) + area(b.position, c.position, point)
            + area(c.position, a.position, point);
        return parts <= 1.01f * area(a.position, b.position, c.position);
    }

    std::string placeOfTriangle(const debug::DrawnTriangle& triangle, Hits hits)
    {
        const auto isHit = [&](const debug::Hit& hit) { return contains(triangle, endOf(hit.ray)); };
        return std::ranges::any_of(hits, isHit) ? "that is hit" : "that is not hit";
    }

    std::string extentOfRay(const Ray& ray, const Surroundings& around)
    {
        const float length = ray.t * glm::length(ray.direction);
        constexpr float beyondAnyScene = 1e4f;
        if (!(length < beyondAnyScene)) // NaN too
            return "endless";
        if (!hitAt(ray.origin, around.hits) || isAtLight(endOf(ray), around))
            return ""; // its place says all
        if (hitAt(endOf(ray), around.hits))
            return "up to the next surface";
        return fmt::format("{:.2g} long", length);
    }

}

std::string placeOf(const debug::Drawn& shape, const Surroundings& around)
{
    return std::visit(make_visitor([&](const debug::DrawnRay& ray) { return placeOfRay(ray.ray, around); },
                          [](const debug::DrawnBox&) { return std::string(); },
                          [&](const debug::DrawnTriangle& triangle) { return placeOfTriangle(triangle, around.hits); },
                          [&](const debug::DrawnSphere& sphere) { return placeOfSphere(sphere, around); }),
        shape);
}

std::string extentOf(const debug::Drawn& shape, const Surroundings& around)
{
    return std::visit(
        make_visitor([&](const debug::DrawnRay& ray) { return extentOfRay(ray.ray, around); },
            [](const debug::DrawnBox& box) {
                return std::string(box.mode == DrawMode::Wireframe ? "wireframe" : "filled");
            },
            [](const debug::DrawnTriangle&) { return std::string(); },
            [](const debug::DrawnSphere& sphere) { return fmt::format("of radius {:.2g}", sphere.radius); }),
        shape);
}

}
