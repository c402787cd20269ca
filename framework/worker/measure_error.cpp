#include "worker/measure_error.h"
#include "bvh.h"
#include "light.h"
#include "recursive.h"
#include "render.h"
#include "scene.h"
#include "truth/light.h"
#include "truth/polygon.h"
#include "values/stopwatch.h"
#include <framework/trackball.h>
#include <glm/geometric.hpp>
#include <memory>

namespace worker {
namespace {

    Sampler samplerFor(Strategy strategy, uint32_t seed)
    {
        switch (strategy) {
        case Strategy::Stratified:
            return Sampler::jittered(seed);
        case Strategy::Owen:
            return Sampler::even(seed);
        default:
            return Sampler(seed);
        }
    }

    // Places at which something is estimated, and what is true there.
    class Subject {
    public:
        virtual ~Subject() = default;
        [[nodiscard]] virtual std::size_t numPlaces() const = 0;
        [[nodiscard]] virtual double truth(std::size_t place) const = 0;
        [[nodiscard]] virtual double estimate(std::size_t place, const ErrorRequest& request, uint32_t seed) = 0;
    };

    void addTriangle(Scene& scene, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
    {
        const glm::vec3 normal = glm::normalize(glm::cross(b - a, c - a));
        const Material white { .kd = glm::vec3(1.0f) };
        scene.meshes.push_back({ { { a, normal, {} }, { b, normal, {} }, { c, normal, {} } }, { { 0, 1, 2 } }, white });
    }

    // A white triangle across the view, which is 1 where it is seen.
    class EdgePixels : public Subject {
    public:
        // corners: on the screen, in pixels.
        explicit EdgePixels(const truth::Polygon& corners)
            : m_camera(0.87f, 4.0f)
        {
            const auto place = [&](std::size_t i) { // on a plane across the view
                const Ray ray = m_camera.generateRay(glm::vec2(corners[i]) / static_cast<float>(side) * 2.0f - 1.0f);
                return ray.origin + 4.0f / glm::dot(ray.direction, m_camera.forward()) * ray.direction;
            };
            addTriangle(m_scene, place(0), place(1), place(2));
            m_scene.lights.emplace_back(PointLight { m_camera.position(), glm::vec3(1.0f) });
            m_bvh = std::make_unique<BVH>(m_scene, m_features);
            for (int y = 0; y < side; ++y) {
                for (int x = 0; x < side; ++x) {
                    const glm::dvec2 lower(x, y);
                    const double covered = truth::areaOf(truth::clipToRectangle(corners, lower, lower + 1.0));
                    if (covered > 0.0 && covered < 1.0)
                        m_pixels.push_back({ { x, y }, covered });
                }
            }
        }

        [[nodiscard]] std::size_t numPlaces() const override { return m_pixels.size(); }
        [[nodiscard]] double truth(std::size_t place) const override { return m_pixels[place].covered; }

        [[nodiscard]] double estimate(std::size_t place, const ErrorRequest& request, uint32_t seed) override
        {
            m_features.numPixelSamples = request.numSamples;
            m_features.enableJitteredSampling = request.strategy == Strategy::Stratified;
            const bool isEven = request.strategy == Strategy::Owen;
            RenderState state { m_scene, m_features, *m_bvh, isEven ? Sampler::even(seed) : Sampler(seed) };
            const auto rays = generatePixelRays(state, m_camera, m_pixels[place].pixel, glm::ivec2(side));
            return static_cast<double>(renderRays(state, rays).x);
        }

    private:
        static constexpr int side = 16;

        struct Pixel {
            glm::ivec2 pixel;
            double covered;
        };

        Trackball m_camera;
        Scene m_scene;
        Features m_features;
        std::unique_ptr<BVH> m_bvh;
        std::vector<Pixel> m_pixels;
    };

    // Points of a floor below a square light, of which a triangle may block a part. So large that the distance that
    // shadow rays keep from surfaces is nothing.
    class LitPoints : public Subject {
    public:
        explicit LitPoints(bool isBlocked)
        {
            const glm::vec3 a { -60, 100, -70 }, b { 70, 110, -50 }, c { -10, 100, 60 };
            if (isBlocked) {
                addTriangle(m_scene, a, b, c);
                m_blocker = { glm::dvec3(a), glm::dvec3(b), glm::dvec3(c) };
            }
            m_features.enableShading = m_features.enableShadows = true;
            m_bvh = std::make_unique<BVH>(m_scene, m_features);
            for (int i = 0; i < numPoints; ++i)
                m_points.emplace_back(0.1f * static_cast<float>(i % 4), 0.0f, 0.1f * static_cast<float>(i / 4));
        }

        [[nodiscard]] std::size_t numPlaces() const override { return m_points.size(); }

        [[nodiscard]] double truth(std::size_t place) const override
        {
            const truth::Receiver receiver { glm::dvec3(m_points[place]), { 0.0, 1.0, 0.0 }, glm::dvec3(1.0) };
            return truth::contribution(m_light, receiver, m_blocker).x;
        }

        [[nodiscard]] double estimate(std::size_t place, const ErrorRequest& request, uint32_t seed) override
        {
            RenderState state { m_scene, m_features, *m_bvh, samplerFor(request.strategy, seed) };
            if (values::EvenNumbers* even = state.sampler.even())
                even->expectPoints(request.numSamples);
            const Ray ray { m_points[place] + glm::vec3(0, 10, 0), { 0, -1, 0 }, 10.0f };
            HitInfo hitInfo { .normal = { 0, 1, 0 } };
            hitInfo.material.kd = glm::vec3(1.0f);
            const glm::vec3 light
                = computeContributionParallelogramLight(state, m_light, ray, hitInfo, request.numSamples);
            return static_cast<double>(light.x);
        }

    private:
        static constexpr int numPoints = 16;

        const glm::vec3 m_white { 1.0f };
        const ParallelogramLight m_light { { -100, 200, -100 }, { 200, 0, 0 }, { 0, 0, 200 }, m_white, m_white, m_white,
            m_white };
        Scene m_scene;
        Features m_features;
        std::unique_ptr<BVH> m_bvh;
        std::vector<glm::dvec3> m_blocker;
        std::vector<glm::vec3> m_points;
    };

    std::unique_ptr<Subject> subjectOf(Integrand integrand)
    {
        switch (integrand) {
        case Integrand::Edge:
            return std::make_unique<EdgePixels>(truth::Polygon { { 1.3, 0.7 }, { 15.1, 4.2 }, { 3.9, 14.6 } });
        case Integrand::AxisEdge: // above a line between two of any grid's
            return std::make_unique<EdgePixels>(truth::Polygon { { -30.0, 7.37 }, { 46.0, 7.37 }, { 8.0, 60.0 } });
        case Integrand::SoftShadow:
            return std::make_unique<LitPoints>(true);
        default:
            return std::make_unique<LitPoints>(false);
        }
    }

}

ErrorAnswer measureError(const ErrorRequest& request)
{
    const std::unique_ptr<Subject> subject = subjectOf(request.integrand);
    std::vector<double> truths, estimates;
    for (std::size_t place = 0; place < subject->numPlaces(); ++place)
        truths.push_back(subject->truth(place));

    const auto estimateAll = [&] {
        for (uint32_t i = 0; i < request.numEstimates; ++i)
            estimates.push_back(subject->estimate(i % truths.size(), request, request.seed + i));
    };
    ErrorAnswer answer { .seconds = values::secondsOf(estimateAll) };
    for (std::size_t i = 0; i < estimates.size(); ++i) {
        const double error = estimates[i] - truths[i % truths.size()];
        answer.mean += error / request.numEstimates;
        answer.meanSquare += error * error / request.numEstimates;
    }
    return answer;
}

}
