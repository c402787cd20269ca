#include "worker/estimates.h"
#include "bvh.h"
#include "light.h"
#include "recursive.h"
#include "render.h"
#include "scene.h"
#include "values/even_numbers.h"
#include "worker/probe.h"
#include <ctime>
#include <framework/trackball.h>
#include <glm/geometric.hpp>

namespace worker {
namespace {

    void addTriangle(Scene& scene, const std::vector<glm::vec3>& corners)
    {
        const glm::vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
        Mesh& mesh = scene.meshes.emplace_back();
        for (const glm::vec3& corner : corners)
            mesh.vertices.push_back({ corner, normal, {} });
        mesh.triangles.emplace_back(0, 1, 2);
        mesh.material.kd = glm::vec3(1.0f);
    }

    // That this thread had a processor: what else the machine does meanwhile does not count.
    double secondsRun()
    {
        timespec time {};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

    // Calls estimateAt(place, seed) for all estimates. Their time is the median of a few parts', as caches are shared.
    template <typename EstimateAt>
    Estimates estimateAll(const EstimateRequest& request, std::size_t numPlaces, const EstimateAt& estimateAt)
    {
        constexpr uint32_t numParts = 15;
        Estimates estimates;
        std::vector<double> secondsEach; // an estimate, by part
        for (uint32_t part = 0, i = 0; part < numParts; ++part) {
            const uint32_t first = i, end = static_cast<uint32_t>(uint64_t(request.number) * (part + 1) / numParts);
            const double start = secondsRun();
            for (; i < end; ++i)
                estimates.values.push_back(estimateAt(i % numPlaces, request.seed + i));
            if (first < end)
                secondsEach.push_back((secondsRun() - start) / (end - first));
        }
        const auto middle = secondsEach.begin() + static_cast<std::ptrdiff_t>(secondsEach.size() / 2);
        std::ranges::nth_element(secondsEach, middle);
        estimates.secondsEach = secondsEach.empty() ? 0.0 : *middle;
        return estimates;
    }

    // On a plane across the view.
    void addTriangles(Scene& scene, const EdgePicture& picture, const Trackball& camera)
    {
        for (const EdgePicture::Corners& corners : picture.triangles) {
            std::vector<glm::vec3> onPlane;
            for (const glm::dvec2& corner : corners) {
                const Ray ray
                    = camera.generateRay(glm::vec2(corner) / static_cast<float>(EdgePicture::side) * 2.0f - 1.0f);
                onPlane.push_back(ray.origin + 4.0f / glm::dot(ray.direction, camera.forward()) * ray.direction);
            }
            addTriangle(scene, onPlane);
        }
    }

    Estimates estimatePixels(const EstimateRequest& request)
    {
        const EdgePicture picture = edgePicture(request.integrand);
        const Trackball camera(0.87f, 4.0f);
        Scene scene;
        addTriangles(scene, picture, camera);
        scene.lights.emplace_back(PointLight { camera.position(), glm::vec3(1.0f) });
        Features features;
        features.enableAccelStructure = true;
        features.numPixelSamples = request.numSamples;
        features.enableJitteredSampling = request.strategy == Strategy::Stratified;
        const BVH bvh(scene, features);
        return estimateAll(request, picture.pixels.size(), [&](std::size_t place, uint32_t seed) {
            values::EvenNumbers even(seed);
            RenderState state { scene, features, bvh,
                request.strategy == Strategy::Owen ? Sampler(even) : Sampler(seed) };
            const glm::ivec2 resolution(EdgePicture::side);
            return renderRays(state, generatePixelRays(state, camera, picture.pixels[place], resolution)).x;
        });
    }

    values::EvenNumbers::Method methodOf(Strategy strategy)
    {
        using Method = values::EvenNumbers::Method;
        return strategy == Strategy::Owen ? Method::Owen
            : strategy == Strategy::Pairs ? Method::OwenPairs
                                          : Method::Jittered;
    }

    Estimates estimateLight(const EstimateRequest& request)
    {
        const LitFloor floor = litFloor(request.integrand);
        Scene scene;
        if (!floor.blocker.empty())
            addTriangle(scene, floor.blocker);
        Features features;
        features.enableShading = features.enableShadows = true;
        const BVH bvh(scene, features);
        HitInfo hitInfo { .normal = { 0.0f, 1.0f, 0.0f } };
        hitInfo.material.kd = glm::vec3(1.0f);
        return estimateAll(request, floor.points.size(), [&](std::size_t place, uint32_t seed) {
            values::EvenNumbers even(seed, methodOf(request.strategy));
            even.expectPoints(request.numSamples);
            RenderState state { scene, features, bvh,
                request.strategy == Strategy::Uniform ? Sampler(seed) : Sampler(even) };
            const Ray ray { floor.points[place] + glm::vec3(0, 10, 0), { 0, -1, 0 }, 10.0f };
            return computeContributionParallelogramLight(state, floor.light, ray, hitInfo, request.numSamples).x;
        });
    }

    const Probe estimates(
        "sampling.estimates", [](Call& call) { call.output << estimate(call.input.read<EstimateRequest>()); });

}

Estimates estimate(const EstimateRequest& request)
{
    const bool isOfPixels = request.integrand == Integrand::Edge || request.integrand == Integrand::AxisEdge;
    return isOfPixels ? estimatePixels(request) : estimateLight(request);
}

}
