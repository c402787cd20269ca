#include "worker/specialised.h"
#include "accel/sphere_test.h"
#include "accel/wide/tree.h"
#include "bvh.h"
#include "intersect.h"
#include "screen.h"
#include "shading.h"
#include "texture.h"
#include "values/needs_of.h"
#include "worker/specialised_formulas.h"
#include <array>
#include <framework/variant_helper.h>
#include <tbb/parallel_for.h>

namespace worker {
namespace {

    // What an instance of the code is compiled for.
    struct Parts {
        bool spheres, textures, shadingNormals, mirrors, transparency;
    };

    struct Surface {
        glm::vec3 way, point, normal; // way: from where the ray started
        glm::vec2 texCoord { 0.0f };
        const Material* material;
    };

    template <Parts parts> class Specialised {
    public:
        Specialised(const Scene& scene, const BVH& bvh, const Features& features, bool isDarkBelow, uint32_t seed)
            : m_scene(scene)
            , m_bvh(bvh)
            , m_tree(*bvh.wideTree())
            , m_primitives(bvh.primitives())
            , m_features(features)
            , m_isDarkBelow(isDarkBelow)
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
            glm::dvec3 sum { 0.0 };
            for (const glm::vec2& position : positions)
                sum += glm::dvec3(through(position));
            return glm::vec3(sum / static_cast<double>(count));
        }

    private:
        glm::vec3 trace(const Ray& ray, uint32_t depth)
        {
            Surface surface;
            float t = ray.t;
            if (!find(ray, surface, t))
                return glm::vec3(0.0f);
            glm::vec3 color = lightOn(surface, ray);
            if (depth >= m_features.extra.maxDepth)
                return color;
            const Material& material = *surface.material;
            const glm::vec3 lifted = offsetOfSum(ray.origin, surface.way) * surface.normal;
            if constexpr (parts.mirrors) {
                if (material.ks != glm::vec3(0.0f)) {
                    const glm::vec3 mirrored
                        = ray.direction - 2.0f * glm::dot(ray.direction, surface.normal) * surface.normal;
                    color += material.ks * trace({ surface.point + lifted, glm::normalize(mirrored) }, depth + 1);
                }
            }
            if constexpr (parts.transparency) {
                if (material.transparency != 1.0f) {
                    const glm::vec3 behind = trace({ surface.point - lifted, ray.direction }, depth + 1);
                    color = glm::mix(behind, color, material.transparency);
                }
            }
            return color;
        }

        // t becomes the distance of the surface.
        bool find(const Ray& ray, Surface& surface, float& t) const
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
                    surface = { {}, {}, info.normal, info.texCoord, &sphere.material };
                }
            }
            t = closest.t;
            surface.way = t * ray.direction;
            surface.point = ray.origin + surface.way;
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
            surface.normal = turnedAgainst(ray.direction, glm::normalize(normal));
        }

        glm::vec3 lightOn(const Surface& surface, const Ray& ray)
        {
            const uint32_t number = m_features.numShadowSamples;
            const glm::vec3 eye = -glm::normalize(ray.direction);
            const glm::vec3 above = surface.point + offsetBetween(ray.origin, surface.point) * surface.normal;
            const auto lightFrom = [&](const glm::vec3& position, const glm::vec3& color) {
                return lightOfSample(position, color, surface, eye, above);
            };
            const auto fromLight
                = make_visitor([&](const PointLight& light) { return lightFrom(light.position, light.color); },
                    [&](const SegmentLight& light) {
                        glm::vec3 sum { 0.0f };
                        for (uint32_t i = 0; i < number; ++i) {
                            const float at = m_sampler.next_1d();
                            sum += lightFrom(glm::mix(light.endpoint0, light.endpoint1, at),
                                glm::mix(light.color0, light.color1, at));
                        }
                        return sum / static_cast<float>(number);
                    },
                    [&](const ParallelogramLight& light) {
                        glm::vec3 sum { 0.0f };
                        for (uint32_t i = 0; i < number; ++i) {
                            const glm::vec2 at = m_sampler.next_2d();
                            const glm::vec3 color = glm::mix(glm::mix(light.color0, light.color1, at.x),
                                glm::mix(light.color2, light.color3, at.x), at.y);
                            sum += lightFrom(light.v0 + at.x * light.edge01 + at.y * light.edge02, color);
                        }
                        return sum / static_cast<float>(number);
                    });
            glm::vec3 sum { 0.0f };
            for (const Scene::SceneLight& light : m_scene.lights)
                sum += std::visit(fromLight, light);
            return sum;
        }

        // above: the surface's point, lifted off it.
        glm::vec3 lightOfSample(const glm::vec3& position, const glm::vec3& color, const Surface& surface,
            const glm::vec3& eye, const glm::vec3& above)
        {
            const glm::vec3 toLight = position - surface.point;
            const float distance = glm::length(toLight);
            if (distance == 0.0f)
                return glm::vec3(0.0f);
            const glm::vec3 direction = toLight / distance;
            const float cosine = glm::dot(surface.normal, direction);
            if (m_isDarkBelow && cosine <= 0.0f)
                return glm::vec3(0.0f);
            const glm::vec3 arriving = m_features.enableShadows ? leftOf(color, position, above) : color;
            if (arriving == glm::vec3(0.0f))
                return arriving;
            return shade(surface, direction, cosine, arriving, eye);
        }

        glm::vec3 leftOf(const glm::vec3& color, const glm::vec3& position, const glm::vec3& above) const
        {
            const glm::vec3 toLight = position - above;
            const float distance = glm::length(toLight);
            Ray remaining { above, toLight / distance, distance - offsetBetween(above, position) };
            if constexpr (!parts.transparency)
                return remaining.t > 0.0f && isBlocked(remaining) ? glm::vec3(0.0f) : color;
            glm::vec3 left = color;
            while (remaining.t > 0.0f && left != glm::vec3(0.0f)) {
                Surface between;
                float t = remaining.t;
                if (!find(remaining, between, t))
                    break;
                left = lightBehind(left, kdOf(between), between.material->transparency, m_features);
                const float step = offsetBetween(remaining.origin, between.point);
                remaining.origin = between.point + step * remaining.direction;
                remaining.t -= t + step;
            }
            return left;
        }

        bool isBlocked(const Ray& ray) const
        {
            if (m_tree.occluded(ray))
                return true;
            if constexpr (parts.spheres) {
                for (const Sphere& sphere : m_scene.spheres)
                    if (accel::meets(sphere, ray))
                        return true;
            }
            return false;
        }

        glm::vec3 kdOf(const Surface& surface) const
        {
            if constexpr (parts.textures) {
                if (const Image* texture = surface.material->kdTexture)
                    return m_features.enableBilinearTextureFiltering ? sampleTextureBilinear(*texture, surface.texCoord)
                                                                     : sampleTextureNearest(*texture, surface.texCoord);
            }
            return surface.material->kd;
        }

        glm::vec3 shade(const Surface& surface, const glm::vec3& direction, float cosine, const glm::vec3& light,
            const glm::vec3& camera)
        {
            const Material& material = *surface.material;
            if (!m_features.enableShading)
                return light * kdOf(surface);
            const glm::vec3 normal = surface.normal;
            switch (m_features.shadingModel) {
            case ShadingModel::Lambertian:
                return light * kdOf(surface) * std::max(cosine, 0.0f);
            case ShadingModel::Phong:
                return light * (kdOf(surface) * cosine + material.ks * phongLobe(material, normal, direction, camera));
            case ShadingModel::BlinnPhong:
                return light * (kdOf(surface) * cosine + material.ks * blinnLobe(material, normal, direction, camera));
            default: // by gradients, which are a submission's
                RenderState state { m_scene, m_features, m_bvh, Sampler(1) };
                return computeShading(
                    state, camera, direction, light, { surface.normal, {}, surface.texCoord, material });
            }
        }

        const Scene& m_scene;
        const BVH& m_bvh;
        const accel::WideTree& m_tree;
        const std::span<const BVHInterface::Primitive> m_primitives;
        const Features& m_features;
        const bool m_isDarkBelow;
        Sampler m_sampler;
    };

    template <Parts parts>
    void renderAll(const Scene& scene, const BVH& bvh, const Features& features, const Trackball& camera,
        Screen& screen, const SceneNeeds& needs)
    {
        const glm::ivec2 resolution = screen.resolution();
        tbb::parallel_for(0, resolution.y, [&](int y) {
            for (int x = 0; x < resolution.x; ++x) {
                Specialised<parts> code(
                    scene, bvh, features, !needs.lightFromBehind, static_cast<uint32_t>(screen.indexAt(x, y)));
                screen.setPixel(x, y, code.pixel(camera, { x, y }, resolution));
            }
        });
    }

    using Render = void (*)(const Scene&, const BVH&, const Features&, const Trackball&, Screen&, const SceneNeeds&);

    template <std::size_t... bits> constexpr std::array<Render, 32> instances(std::index_sequence<bits...>)
    {
        return {
            renderAll<Parts { bool(bits & 1), bool(bits & 2), bool(bits & 4), bool(bits & 8), bool(bits & 16) }>...
        };
    }

}

void renderSpecialised(
    const Scene& scene, const BVH& bvh, const Features& features, const Trackball& camera, Screen& screen)
{
    static constexpr auto renders = instances(std::make_index_sequence<32> {});
    const SceneNeeds needs = values::needsOf(scene, features);
    const auto index = static_cast<std::size_t>(
        needs.spheres | needs.textures << 1 | needs.shadingNormals << 2 | needs.mirrors << 3 | needs.transparency << 4);
    renders[index](scene, bvh, features, camera, screen, needs);
}

}
