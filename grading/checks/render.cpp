#include "render.h"
#include "config.h"
#include "grading/check.h"
#include "grading/chi_square.h"
#include "grading/expect.h"
#include "grading/picture.h"
#include "grading/probes/pixel_case.h"
#include <fmt/format.h>

namespace grading {
namespace {

    // Deviations that chance exceeds with probability 6e-7.
    constexpr double significant = 5.0;

    struct Sampling {
        std::string probe;
        std::string function;
    };
    const Sampling uniform { "render.uniform", "generatePixelRaysUniform" };
    const Sampling stratified { "render.stratified", "generatePixelRaysStratified" };

    Config randomConfig(Random& random, uint32_t numSamples)
    {
        Config config;
        config.size = { random.integer(20, 60), random.integer(20, 60) };
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

    // Where a camera ray meets the screen, in pixels from the bottom left: the camera's projection, inverted.
    glm::dvec2 positionOf(const Config& config, const Ray& ray)
    {
        const Trackball camera = makeTrackball(config);
        const glm::dvec3 direction(ray.direction);
        const double forward = glm::dot(direction, glm::dvec3(camera.forward()));
        const double tangent = std::tan(glm::radians(static_cast<double>(config.camera.fieldOfView)) / 2.0);
        const glm::dvec2 size(config.size);
        const glm::dvec2 ndc { -glm::dot(direction, glm::dvec3(camera.left())) / forward / (tangent * size.x / size.y),
            glm::dot(direction, glm::dvec3(camera.up())) / forward / tangent };
        return (ndc + 1.0) * 0.5 * size;
    }

    // The places of a pixel's rays in it, in [0, 1]^2.
    using Samples = std::vector<glm::dvec2>;

    std::vector<Samples> samplesOf(
        Exam& exam, const Sampling& sampling, const Config& config, const std::vector<PixelCase>& pixels)
    {
        const auto rays = exam.ask<std::vector<std::vector<Ray>>>(sampling.probe, config, pixels);
        expectCount(sampling.function, rays.size(), pixels.size());
        std::vector<Samples> samples(pixels.size());
        for (std::size_t i = 0; i < pixels.size(); ++i)
            for (const Ray& ray : rays[i])
                samples[i].push_back(positionOf(config, ray) - glm::dvec2(pixels[i].pixel));
        return samples;
    }

    void compareCount(Exam& exam, const Sampling& sampling, const std::vector<uint32_t>& numbers)
    {
        for (const uint32_t number : numbers) {
            const Config config = randomConfig(exam.random, number);
            const Samples samples = samplesOf(exam, sampling, config, randomPixels(exam.random, config, 1)).front();
            expectCount(fmt::format("{} with numPixelSamples = {}", sampling.function, number), samples.size(), number);
        }
    }

    void compareRange(Exam& exam, const Sampling& sampling)
    {
        constexpr double rounding = 1e-3; // of a pixel: a direction of 24 bits over 60 pixels
        const Config config = randomConfig(exam.random, 25);
        for (const Samples& samples : samplesOf(exam, sampling, config, randomPixels(exam.random, config, 100))) {
            for (const glm::dvec2& s : samples) {
                const bool inside
                    = s.x >= -rounding && s.x <= 1.0 + rounding && s.y >= -rounding && s.y <= 1.0 + rounding;
                expect(
                    inside, sampling.function, "a ray at " + toText(glm::vec2(s)) + " of its pixel", "[0, 1) x [0, 1)");
            }
        }
    }

    int cellOf(const glm::dvec2& position, int n)
    {
        const glm::ivec2 cell = glm::clamp(glm::ivec2(glm::floor(position * static_cast<double>(n))), 0, n - 1);
        return cell.y * n + cell.x;
    }

    // Counts the positions in a grid of n x n cells.
    std::vector<int> countCells(const Samples& positions, int n)
    {
        std::vector<int> counts(static_cast<std::size_t>(n * n), 0);
        for (const glm::dvec2& position : positions)
            ++counts[static_cast<std::size_t>(cellOf(position, n))];
        return counts;
    }

    Samples together(const std::vector<Samples>& pixels)
    {
        Samples all;
        for (const Samples& samples : pixels)
            all.insert(all.end(), samples.begin(), samples.end());
        return all;
    }

    void expectRandom(const std::string& asked, const Samples& positions, int n)
    {
        const double deviations = unevenness(countCells(positions, n));
        expect(deviations < significant, asked,
            fmt::format("positions {:.0f} standard deviations too uneven over {} x {} cells", deviations, n, n),
            "uniform ones");
        expect(deviations > -significant, asked,
            fmt::format("positions {:.0f} standard deviations too even over {} x {} cells", -deviations, n, n),
            "independent ones, which clump");
    }

    const Check uniformCount(
        "multisampling.uniform.count", 1.0, "numPixelSamples is the number of rays, not its square", [](Exam& exam) {
            compareCount(exam, uniform, { 2, 5, 16, 25 });
        });

    const Check uniformRange("multisampling.uniform.range", 1.0,
        "pixel (x, y) covers [x, x+1) x [y, y+1) of the resolution, which is mapped to [-1, 1]; random numbers are in "
        "[0, 1)",
        [](Exam& exam) { compareRange(exam, uniform); });

    const Check uniformDistribution("multisampling.uniform.distribution", 2.0,
        "each ray goes through a point of its own, with a new random number for x and another for y; no grid",
        [](Exam& exam) {
            const Config config = randomConfig(exam.random, 16);
            const auto pixels = samplesOf(exam, uniform, config, randomPixels(exam.random, config, 600));
            const Samples all = together(pixels);
            expect(!all.empty(), uniform.function, "no rays", "16 a pixel");
            expectRandom(uniform.function, all, 4); // as many cells as rays a pixel: a jittered grid is too even
            expectRandom(uniform.function, all, 13);
        });

    const Check stratifiedCount(
        "multisampling.stratified.count", 1.0, "n = round(sqrt(numPixelSamples)), and n x n rays", [](Exam& exam) {
            compareCount(exam, stratified, { 4, 9, 16, 25 });
        });

    const Check stratifiedCells("multisampling.stratified.cells", 2.0,
        "cell (i, j) begins at (i, j) / n of the pixel: integer division gives 0; one ray in each", [](Exam& exam) {
            compareRange(exam, stratified);
            for (const uint32_t number : { 9u, 16u, 25u }) {
                const int n = static_cast<int>(std::sqrt(number));
                const Config config = randomConfig(exam.random, number);
                for (const Samples& samples :
                    samplesOf(exam, stratified, config, randomPixels(exam.random, config, 50))) {
                    const std::vector<int> counts = countCells(samples, n);
                    // A ray may be rounded over the border of its cell: then its own is empty and the neighbour has
                    // two.
                    const auto empty = std::count(counts.begin(), counts.end(), 0);
                    expect(empty <= 1 && samples.size() == counts.size(), stratified.function,
                        fmt::format("{} rays, {} of {} cells empty", samples.size(), empty, counts.size()),
                        "one ray in each cell");
                }
            }
        });

    const Check stratifiedJitter("multisampling.stratified.jitter", 2.0,
        "within its cell a ray is anywhere: two random numbers, divided by n and not by n * n", [](Exam& exam) {
            constexpr int n = 4;
            const Config config = randomConfig(exam.random, n * n);
            Samples inCells;
            for (const Samples& samples : samplesOf(exam, stratified, config, randomPixels(exam.random, config, 600)))
                for (const glm::dvec2& s : samples)
                    inCells.push_back(glm::fract(s * static_cast<double>(n)));
            expect(!inCells.empty(), stratified.function, "no rays", "16 a pixel");
            expectRandom(stratified.function + ", places in the cells", inCells, 4);
            expectRandom(stratified.function + ", places in the cells", inCells, 11);
        });

    const Check picture("multisampling.picture.edges", 1.0, "see the checks of the pixel rays", [](Exam& exam) {
        comparePicture(exam, pictureOf("multisampling"));
        comparePicture(exam, pictureOf("multisampling", { { "jittered_sampling", "false" } }));
    });

}
}
