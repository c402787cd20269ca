#include "grading/oracle/brute_force.h"
#include <array>
#include <optional>

namespace grading {
namespace {

    constexpr double clearDistance = 1e-3; // between two hits, of scenes with a size of about 1
    constexpr double clearBarycentric = 0.01; // to an edge
    constexpr double clearCosine = 0.05; // to a grazing ray
    constexpr double clearRadius = 0.01; // to a sphere's outline, in radii

    struct Line {
        glm::dvec3 origin, direction;
        double length; // of direction

        [[nodiscard]] glm::dvec3 at(double t) const { return origin + t * direction; }
    };

    Line lineOf(const glm::dvec3& origin, const glm::dvec3& direction)
    {
        return { origin, direction, glm::length(direction) };
    }

    struct Crossing {
        double t;
        bool isInside; // otherwise the ray passes close by
        bool isClear;
        glm::dvec3 barycentric { 0.0 };
        glm::dvec3 normal { 0.0 };
    };

    std::array<glm::dvec3, 3> cornersOf(const Mesh& mesh, const glm::uvec3& triangle)
    {
        const auto corner = [&](int i) { return glm::dvec3(mesh.vertices[triangle[i]].position); };
        return { corner(0), corner(1), corner(2) };
    }

    // Where the line meets the triangle's plane, if in the triangle or close to it. Compares areas before dividing by
    // them, so that a ray through an edge with short binary coordinates is decided exactly.
    std::optional<Crossing> cross(const Line& line, const std::array<glm::dvec3, 3>& corners)
    {
        const auto& [a, b, c] = corners;
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        const double speed = glm::dot(normal, line.direction);
        if (speed == 0.0) // no area, or edge-on
            return std::nullopt;
        const double t = glm::dot(normal, a - line.origin) / speed;
        const glm::dvec3 p = line.at(t);
        const glm::dvec3 areas { glm::dot(normal, glm::cross(c - b, p - b)), glm::dot(normal, glm::cross(a - c, p - c)),
            glm::dot(normal, glm::cross(b - a, p - a)) };
        const glm::dvec3 barycentric = areas / glm::dot(normal, normal);
        const double margin = std::min({ barycentric.x, barycentric.y, barycentric.z });
        if (margin < -clearBarycentric)
            return std::nullopt;
        const bool grazes = std::abs(speed) < clearCosine * glm::length(normal) * line.length;
        return Crossing { t, std::min({ areas.x, areas.y, areas.z }) >= 0.0, margin > clearBarycentric && !grazes,
            barycentric, glm::normalize(speed > 0.0 ? -normal : normal) };
    }

    // Where the line meets the sphere: from outside where it enters, from inside where it leaves.
    std::optional<Crossing> cross(const Line& line, const Sphere& sphere)
    {
        const double radius { sphere.radius };
        const double tMiddle
            = glm::dot(glm::dvec3(sphere.center) - line.origin, line.direction) / (line.length * line.length);
        const glm::dvec3 offset = line.at(tMiddle) - glm::dvec3(sphere.center);
        const double squared = radius * radius - glm::dot(offset, offset);
        const bool isClear = std::abs(glm::length(offset) - radius) > clearRadius * radius;
        if (squared < 0.0)
            return isClear ? std::nullopt : std::optional(Crossing { tMiddle, false, false });
        const double half = std::sqrt(squared) / line.length;
        const bool startsOn = std::abs(tMiddle - half) * line.length < clearDistance;
        return Crossing { tMiddle - half >= 0.0 ? tMiddle - half : tMiddle + half, true, isClear && !startsOn };
    }

    // Calls f(material, mesh or null, triangle, crossing) for whatever the line meets.
    template <typename F> void forEachCrossing(const Scene& scene, const Line& line, const F& f)
    {
        for (const Mesh& mesh : scene.meshes)
            for (const glm::uvec3& triangle : mesh.triangles)
                if (const auto crossing = cross(line, cornersOf(mesh, triangle)))
                    f(mesh.material, &mesh, triangle, *crossing);
        for (const Sphere& sphere : scene.spheres)
            if (const auto crossing = cross(line, sphere))
                f(sphere.material, nullptr, glm::uvec3(0), *crossing);
    }

}

SceneHit closestHit(const Scene& scene, const Ray& ray)
{
    const Line line = lineOf(glm::dvec3(ray.origin), glm::dvec3(ray.direction));
    const double margin = clearDistance / line.length;
    SceneHit closest;
    closest.t = static_cast<double>(ray.t);
    forEachCrossing(
        scene, line, [&](const Material& material, const Mesh* mesh, const glm::uvec3& triangle, const Crossing& c) {
            if (c.isInside && c.t >= 0.0 && c.t <= closest.t)
                closest = { true, true, c.t, &material, mesh, triangle, c.barycentric, c.normal };
        });
    int numClose = 0; // whatever might be met before or just behind the closest
    forEachCrossing(scene, line, [&](const Material&, const Mesh*, const glm::uvec3&, const Crossing& c) {
        if (c.t < -margin || c.t > closest.t + margin)
            return;
        ++numClose;
        closest.isClear &= c.isClear && c.t > margin;
    });
    const bool endsOn = closest.isHit && static_cast<double>(ray.t) - closest.t < margin;
    closest.isClear &= !endsOn && numClose == (closest.isHit ? 1 : 0);
    return closest;
}

bool isBlocked(const Scene& scene, const glm::dvec3& from, const glm::dvec3& to)
{
    bool blocked = false;
    forEachCrossing(
        scene, lineOf(from, to - from), [&](const Material&, const Mesh*, const glm::uvec3&, const Crossing& c) {
            blocked |= c.isInside && c.t > 0.0 && c.t < 1.0;
        });
    return blocked;
}

}
