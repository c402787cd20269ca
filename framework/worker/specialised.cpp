#include "worker/specialised.h"
#include "accel/wide/tree.h"
#include "bvh.h"
#include "intersect.h"
#include "screen.h"
#include "shading.h"
#include "texture.h"
#include "values/needs_of.h"
#include <framework/variant_helper.h>
#include <tbb/parallel_for.h>

namespace worker {
namespace {

    // What an instance of the code is compiled for.
    struct Parts {
        bool spheres, textures, shadingNormals, mirrors, transparency;
    };

    struct Surface {
        glm::vec3 point, normal;
        glm::vec2 texCoord;
        const Material* material;
    };

    template <Parts parts> class Specialised {
    public:
        Specialised(const Scene& scene, const BVH& bvh, const Features& features, uint32_t seed)
            : m_scene(scene)
            , m_tree(*bvh.wideTree())
            , m_primitives(bvh.primitives())
            , m_features(features)
            , m_sampler(seed)
        {
        }

        glm::vec3 pixel(const Trackball& camera, glm::ivec2 pixel, glm::ivec2 resolution)
        {
            const auto through = [&](const glm::vec2& position) {
                return trace(camera.generateRay(position / glm::vec2(resolution) * 2.0f - 1.0f), 0);
            };
            const uint32_t number = m_features.numPixelSamples;
            if (number == 1)
                return through(glm::vec2(pixel) + 0.5f);
            const auto n = static_cast<uint32_t>(std::round(std::sqrt(static_cast<float>(number))));
            const uint32_t side = m_features.enableJitteredSampling ? n : 1;
            const uint32_t count = m_features.enableJitteredSampling ? n * n : number;
            std::vector<glm::vec2> positions; // all before the first ray, whose lights take random numbers too
            positions.reserve(count);
            for (uint32_t i = 0; i < count; ++i) {
                const glm::vec2 cell(static_cast<float>(i % side), static_cast<float>(i / side % side));
                positions.push_back(glm::vec2(pixel) + (cell + m_sampler.next_2d()) / static_cast<float>(side));
            }
            glm::vec3 sum { 0.0f };
            for (const glm::vec2& position : positions)
                sum += through(position);
            return sum / static_cast<float>(count);
        }

    private:
        glm::vec3 trace(const Ray& ray, uint32_t depth)
        {
            Surface surface;
            if (!find(ray, surface))
                return glm::vec3(0.0f);
            glm::vec3 color = lightOn(surface, ray);
            if (depth >= m_features.extra.maxDepth)
                return color;
            const Material& material = *surface.material;
            if constexpr (parts.mirrors) {
                if (material.ks != glm::vec3(0.0f)) {
                    const glm::vec3 mirrored
                        = ray.direction - 2.0f * glm::dot(ray.direction, surface.normal) * surface.normal;
                    const glm::vec3 origin = surface.point + offsetAt(surface.point) * surface.normal;
                    color += material.ks * trace({ origin, glm::normalize(mirrored) }, depth + 1);
                }
            }
            if constexpr (parts.transparency) {
                if (material.transparency != 1.0f) {
                    const glm::vec3 origin = surface.point - offsetAt(surface.point) * surface.normal;
                    color = glm::mix(trace({ origin, ray.direction }, depth + 1), color, material.transparency);
                }
            }
            return color;
        }

        bool find(const Ray& ray, Surface& surface) const
        {
            Ray closest = ray;
            const auto hit = m_tree.closest(ray);
            if (hit) {
                closest.t = hit->t;
                describe(*hit, ray, surface);
            }
            bool isSphere = false;
            if constexpr (parts.spheres) {
                for (const Sphere& sphere : m_scene.spheres) {
                    HitInfo info;
                    if (!intersectRayWithShape(sphere, closest, info))
                        continue;
                    isSphere = true;
                    surface = { {}, info.normal, info.texCoord, &sphere.material };
                }
            }
            surface.point = ray.origin + closest.t * ray.direction;
            return hit || isSphere;
        }

        void describe(const accel::WideTree::Hit& hit, const Ray& ray, Surface& surface) const
        {
            const auto& [meshID, v0, v1, v2] = m_primitives[hit.primitive];
            const glm::vec3 weights { 1.0f - hit.u - hit.v, hit.u, hit.v };
            surface.material = &m_scene.meshes[meshID].material;
            if constexpr (parts.textures)
                surface.texCoord = weights.x * v0.texCoord + weights.y * v1.texCoord + weights.z * v2.texCoord;
            glm::vec3 normal = glm::cross(v1.position - v0.position, v2.position - v0.position);
            if constexpr (parts.shadingNormals) {
                const glm::vec3 between = weights.x * v0.normal + weights.y * v1.normal + weights.z * v2.normal;
                if (glm::dot(between, between) > 0.0f)
                    normal = between;
            }
            surface.normal = glm::normalize(normal);
            if (glm::dot(surface.normal, ray.direction) > 0.0f)
                surface.normal = -surface.normal;
        }

        static float offsetAt(const glm::vec3& point)
        {
            const glm::vec3 size = glm::abs(point);
            return 1e-4f * std::max({ 1.0f, size.x, size.y, size.z });
        }

        glm::vec3 lightOn(const Surface& surface, const Ray& ray)
        {
            const uint32_t number = m_features.numShadowSamples;
            const auto fromLight = make_visitor(
                [&](const PointLight& light) { return lightFrom(light.position, light.color, surface, ray); },
                [&](const SegmentLight& light) {
                    glm::vec3 sum { 0.0f };
                    for (uint32_t i = 0; i < number; ++i) {
                        const float at = m_sampler.next_1d();
                        sum += lightFrom(glm::mix(light.endpoint0, light.endpoint1, at),
                            glm::mix(light.color0, light.color1, at), surface, ray);
                    }
                    return sum / static_cast<float>(number);
                },
                [&](const ParallelogramLight& light) {
                    glm::vec3 sum { 0.0f };
                    for (uint32_t i = 0; i < number; ++i) {
                        const glm::vec2 at = m_sampler.next_2d();
                        const glm::vec3 color = glm::mix(glm::mix(light.color0, light.color1, at.x),
                            glm::mix(light.color2, light.color3, at.x), at.y);
                        sum += lightFrom(light.v0 + at.x * light.edge01 + at.y * light.edge02, color, surface, ray);
                    }
                    return sum / static_cast<float>(number);
                });
            glm::vec3 sum { 0.0f };
            for (const Scene::SceneLight& light : m_scene.lights)
                sum += std::visit(fromLight, light);
            return sum;
        }

        glm::vec3 lightFrom(
            const glm::vec3& position, const glm::vec3& color, const Surface& surface, const Ray& ray)
        {
            const glm::vec3 toLight = position - surface.point;
            const glm::vec3 direction = toLight / glm::length(toLight);
            const float cosine = glm::dot(surface.normal, direction);
            if (m_isDarkBelow && cosine <= 0.0f)
                return glm::vec3(0.0f);
            const glm::vec3 arriving = m_features.enableShadows ? leftOf(color, position, surface) : color;
            if (arriving == glm::vec3(0.0f))
                return arriving;
            return shade(surface, direction, cosine, arriving, -glm::normalize(ray.direction));
        }

        glm::vec3 leftOf(const glm::vec3& color, const glm::vec3& position, const Surface& surface) const
        {
            const float offset = offsetAt(surface.point);
            const glm::vec3 origin = surface.point + offset * surface.normal;
            const glm::vec3 toLight = position - origin;
            const float distance = glm::length(toLight);
            Ray remaining { origin, toLight / distance, distance - offset };
            if constexpr (!parts.transparency)
                return remaining.t > 0.0f && isBlocked(remaining) ? glm::vec3(0.0f) : color;
            glm::vec3 left = color;
            while (remaining.t > 0.0f && left != glm::vec3(0.0f)) {
                Surface between;
                if (!find(remaining, between))
                    break;
                const float t = m_features.extra.enableProposedShadowFormula ? -1.0f : 0.0f;
                (void)t;
                left = left * kdOf(between) * (1.0f - between.material->transparency);
                const float passed = glm::length(between.point - remaining.origin);
                (void)passed;
                break;
            }
            return left;
        }

        const Scene& m_scene;
        const accel::WideTree& m_tree;
        const std::span<const BVHInterface::Primitive> m_primitives;
        const Features& m_features;
        Sampler m_sampler;
    };

}
}
