#include "bench/ray_sets.h"
#include "sampler.h"
#include <glm/gtc/constants.hpp>

namespace bench {
namespace {

    void addPrimary(const Trackball& camera, std::size_t numRays, std::vector<Ray>& rays)
    {
        const auto side = static_cast<int>(std::sqrt(static_cast<double>(numRays)));
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const glm::vec2 pixel = (glm::vec2(x, y) + 0.5f) / static_cast<float>(side);
                rays.push_back(camera.generateRay(2.0f * pixel - 1.0f));
            }
        }
    }

    // Uniform on the sphere and then added to the normal: cosine-weighted about it.
    glm::vec3 sampleCosine(const glm::vec3& normal, Sampler& sampler)
    {
        const float z = 1.0f - 2.0f * sampler.next_1d(), angle = glm::two_pi<float>() * sampler.next_1d();
        const float radius = std::sqrt(std::max(0.0f, 1.0f - z * z));
        const glm::vec3 direction = normal + glm::vec3(radius * std::cos(angle), radius * std::sin(angle), z);
        return glm::dot(direction, direction) > 1e-6f ? glm::normalize(direction) : normal;
    }

    struct Surface {
        glm::vec3 point, normal; // a little off the surface; on the side that the ray came from
    };

    Surface surfaceAt(const Triangle& triangle, const Ray& ray, float t)
    {
        const auto& [a, b, c] = triangle;
        glm::vec3 normal = glm::cross(b - a, c - a);
        normal = glm::dot(normal, normal) > 0.0f ? glm::normalize(normal) : -ray.direction;
        if (glm::dot(normal, ray.direction) > 0.0f)
            normal = -normal;
        return { ray.origin + t * ray.direction + 1e-4f * t * normal, normal };
    }

}

std::vector<RaySet> makeRaySets(const Model& model, const accel::WideTree& tree, std::size_t numRays)
{
    RaySet primary { "primary", Question::Closest, {} }, diffuse { "diffuse", Question::Closest, {} },
        shadow { "shadow", Question::Occluded, {} };
    for (const Trackball& camera : model.cameras)
        addPrimary(camera, numRays / model.cameras.size(), primary.rays);

    Sampler sampler(1);
    std::size_t light = 0;
    for (const Ray& ray : primary.rays) {
        const auto hit = tree.closest(ray);
        if (!hit)
            continue;
        const Surface surface = surfaceAt(model.triangles[hit->primitive], ray, hit->t);
        diffuse.rays.push_back({ surface.point, sampleCosine(surface.normal, sampler) });
        shadow.rays.push_back({ surface.point, model.lights[light++ % model.lights.size()] - surface.point, 0.999f });
    }
    return { std::move(primary), std::move(diffuse), std::move(shadow) };
}

}
