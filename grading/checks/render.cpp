#include "render.h"
#include "config.h"
#include "grading/check.h"
#include "grading/checks/render_places.h"
#include "grading/expect.h"
#include "grading/picture.h"
#include "grading/probes/pixel_case.h"
#include <fmt/format.h>

namespace grading::render {
namespace {

    struct Sampling {
        std::string probe;
        std::string function;
    };
    const Sampling uniform { "render.uniform", "generatePixelRaysUniform" };
    const Sampling stratified { "render.stratified", "generatePixelRaysStratified" };

    Config randomConfig(Random& random, uint32_t numSamples)
    {
        Config config;
        config.size = { random.integer(20, 60), random.integer(20, 59) };
        config.size.y += config.size.y >= config.size.x ? 1 : 0; // one for the other would show
        config.camera.lookAt = random.vec3(-1.0f, 1.0f);
        config.camera.rotation = random.vec3(-180.0f, 180.0f);
        config.features.numPixelSamples = numSamples;
        return config;
    }

    std::vector<PixelCase> randomPixels(Random& random, const Config& config, int count)
    {
        std::vector<PixelCase> pixels;
        for (int i = 0; i < count; ++i)
            pixels.push_back(
                { { random.integer(0, config.size.x - 1), random.integer(0, config.size.y - 1) }, random.seed() });
        return pixels;
    }

    // Where a camera ray meets the screen, in pixels from the bottom left: the camera's projection, inverted. Rays that
    // lead away from the screen are far below it.
    glm::dvec2 positionOf(const Config& config, const Ray& ray)
    {
        const Trackball camera = makeTrackball(config);
        const glm::dvec3 direction(ray.direction);
        const double forward = glm::dot(direction, glm::dvec3(camera.forward()));
        if (!(forward > 0.0 && std::isfinite(forward)))
            return glm::dvec2(-1e6);
        const double tangent = std::tan(glm::radians(static_cast<double>(config.camera.fieldOfView)) / 2.0);
        const glm::dvec2 size(config.size);
        const glm::dvec2 ndc { -glm::dot(direction, glm::dvec3(camera.left())) / forward / (tangent * size.x / size.y),
            glm::dot(direction, glm::dvec3(camera.up())) / forward / tangent };
        return (ndc + 1.0) * 0.5 * size;
    }
    constexpr double rounding = 1e-3; // of a pixel: a direction of 24 bits over 60 pixels

    std::vector<std::vector<Ray>> raysOf(
        Exam& exam, const Sampling& sampling, const Config& config, const std::vector<PixelCase>& pixels)
    {
        auto rays = exam.ask<std::vector<std::vector<Ray>>>(sampling.probe, config, pixels);
        expectCount(sampling.function, rays.size(), pixels.size());
        return rays;
    }

    std::vector<Places> placesOf(
        Exam& exam, const Sampling& sampling, const Config& config, const std::vector<PixelCase>& pixels)
    {
        const auto rays = raysOf(exam, sampling, config, pixels);
        std::vector<Places> places(pixels.size());
        for (std::size_t i = 0; i < pixels.size(); ++i)
            for (const Ray& ray : rays[i])
                places[i].push_back(positionOf(config, ray) - glm::dvec2(pixels[i].pixel));
        return places;
    }

    // 16 rays for each of 600 pixels, the first two of which are one pixel with two seeds: each ray is anywhere in its
    // cell, of n x n in a pixel. Which cell that is, other checks ask.
    void compareWithinCells(Exam& exam, const Sampling& sampling, int n)
    {
        const Config config = randomConfig(exam.random, 16);
        std::vector<PixelCase> cases = randomPixels(exam.random, config, 600);
        cases[1].pixel = cases[0].pixel;
        std::vector<Places> pixels = placesOf(exam, sampling, config, cases);
        expect(!pixels[0].empty(), sampling.function, "no rays", "16 a pixel");
        expect(pixels[0] != pixels[1], sampling.function + " for one pixel and two seeds of state.sampler",
            "the same rays", "rays that follow from state.sampler");
        for (Places& places : pixels)
            for (glm::dvec2& place : places)
                place = glm::fract(place * static_cast<double>(n));
        expectIndependent(
            fmt::format("{}, places in {},", sampling.function, n == 1 ? "the pixel" : "the cells"), pixels);
    }

    void compareCount(Exam& exam, const Sampling& sampling, const std::vector<uint32_t>& numbers)
    {
        for (const uint32_t number : numbers) {
            const Config config = randomConfig(exam.random, number);
            const auto rays = raysOf(exam, sampling, config, randomPixels(exam.random, config, 1));
            expectCount(fmt::format("{} with numPixelSamples = {}", sampling.function, number), rays[0].size(), number);
        }
    }

    void compareRay(const Sampling& sampling, const Config& config, const PixelCase& pixel, const Ray& ray)
    {
        const std::string asked = fmt::format("{} for pixel ({}, {}) of {} x {}", sampling.function, pixel.pixel.x,
            pixel.pixel.y, config.size.x, config.size.y);
        const glm::dvec2 place = positionOf(config, ray) - glm::dvec2(pixel.pixel);
        const bool inside
            = place.x >= -rounding && place.x <= 1.0 + rounding && place.y >= -rounding && place.y <= 1.0 + rounding;
        expect(inside, asked, "a ray at " + toText(glm::vec2(place)) + " of its pixel", "[0, 1) x [0, 1)");
        expectNear(
            "the origin of a ray of " + asked, ray.origin, glm::dvec3(makeTrackball(config).position()), fewRoundings);
        expect(ray.t >= FLT_MAX, "t of a ray of " + asked, toText(ray.t), "FLT_MAX");
    }

    void compareRange(Exam& exam, const Sampling& sampling)
    {
        const Config config = randomConfig(exam.random, 25);
        const std::vector<PixelCase> pixels = randomPixels(exam.random, config, 100);
        const auto rays = raysOf(exam, sampling, config, pixels);
        for (std::size_t i = 0; i < pixels.size(); ++i)
            for (const Ray& ray : rays[i])
                compareRay(sampling, config, pixels[i], ray);
    }

    // n x n rays. One that is rounded over the border of its cell is not held against it: no cell has two inside.
    void expectOneInEach(const std::string& asked, const Places& places, int n)
    {
        const double margin = rounding * n;
        Places inside;
        for (const glm::dvec2& place : places) {
            const glm::dvec2 inCell = glm::fract(place * static_cast<double>(n));
            if (std::min(inCell.x, inCell.y) > margin && std::max(inCell.x, inCell.y) < 1.0 - margin)
                inside.push_back(place);
        }
        for (const int count : countCells(inside, n, n))
            expect(count <= 1, asked, fmt::format("{} rays in one of {} x {} cells", count, n, n), "one in each");
    }

    const Check uniformCount(
        "multisampling.uniform.count", 1.0, "numPixelSamples is the number of rays, not its square", [](Exam& exam) {
            compareCount(exam, uniform, { 1, 2, 5, 16, 25 });
        });

    const Check uniformRange("multisampling.uniform.range", 1.0,
        "pixel (x, y) covers [x, x+1) x [y, y+1) of the resolution, which is mapped to [-1, 1]; random numbers are in "
        "[0, 1)",
        [](Exam& exam) { compareRange(exam, uniform); });

    const Check uniformDistribution("multisampling.uniform.distribution", 2.0,
        "each ray goes through a point of its own, with a new random number for x and another for y; no grid",
        [](Exam& exam) { compareWithinCells(exam, uniform, 1); });

    const Check stratifiedCount(
        "multisampling.stratified.count", 1.0, "n = round(sqrt(numPixelSamples)), and n x n rays", [](Exam& exam) {
            compareCount(exam, stratified, { 1, 4, 9, 16, 25, 36, 49, 64, 81, 100 });
        });

    const Check stratifiedCells("multisampling.stratified.cells", 2.0,
        "cell (i, j) begins at (i, j) / n of the pixel: integer division gives 0; one ray in each", [](Exam& exam) {
            compareRange(exam, stratified);
            for (const uint32_t number : { 9u, 16u, 25u }) {
                const int n = static_cast<int>(std::sqrt(number));
                const Config config = randomConfig(exam.random, number);
                for (const Places& places : placesOf(exam, stratified, config, randomPixels(exam.random, config, 50))) {
                    expectCount(stratified.function, places.size(), number);
                    expectOneInEach(stratified.function, places, n);
                }
            }
        });

    const Check stratifiedJitter("multisampling.stratified.jitter", 2.0,
        "within its cell a ray is anywhere: two random numbers, divided by n and not by n * n",
        [](Exam& exam) { compareWithinCells(exam, stratified, 4); });

    const Check picture("multisampling.picture.edges", 1.0, "see the checks of the pixel rays", [](Exam& exam) {
        comparePicture(exam, pictureOf("multisampling"));
        // Independent rays are noisy: where bright bars cross the dark they would take sixteen times as many.
        comparePicture(exam, pictureOf("normal_interpolation", { { "jittered_sampling", "false" } }));
    });

}
}
