#include "grading/chi_square.h"
#include "render.h"
#include "world.h"
#include <catch2/catch.hpp>
#include <framework/trackball.h>

using namespace tests;
using grading::Random;

namespace {

constexpr glm::ivec2 resolution { 40, 30 };
constexpr float fieldOfView = 0.9f;
constexpr double aspectRatio = 4.0 / 3.0;

Trackball makeCamera()
{
    Trackball camera(fieldOfView, 2.0f, static_cast<float>(aspectRatio));
    camera.setCamera({ 0.5f, -1.0f, 2.0f }, { 0.3f, -0.8f, 0.2f }, 2.0f);
    return camera;
}

// Where a camera ray passes the screen, in pixels from the bottom left.
glm::dvec2 positionOf(const Trackball& camera, const Ray& ray)
{
    const glm::dvec3 d { ray.direction };
    const double scale = glm::dot(d, glm::dvec3(camera.forward())) * std::tan(static_cast<double>(fieldOfView) / 2.0);
    const glm::dvec2 ndc { -glm::dot(d, glm::dvec3(camera.left())) / scale / aspectRatio,
        glm::dot(d, glm::dvec3(camera.up())) / scale };
    return (ndc + 1.0) / 2.0 * glm::dvec2(resolution);
}

constexpr double pixelRounding = 1e-4; // 40 pixels, and a few roundings of 1e-7

using Generate = std::vector<Ray> (*)(RenderState&, const Trackball&, glm::ivec2, glm::ivec2);

// Positions in the pixel, of many calls.
std::vector<glm::dvec2> positionsInPixel(Generate generate, uint32_t numSamples, int calls)
{
    World world({}, { .numPixelSamples = numSamples });
    const Trackball camera = makeCamera();
    const glm::ivec2 pixel { 7, 19 };
    std::vector<glm::dvec2> positions;
    for (int i = 0; i < calls; ++i)
        for (const Ray& ray : generate(world.state, camera, pixel, resolution))
            positions.push_back(positionOf(camera, ray) - glm::dvec2(pixel));
    return positions;
}

int cellOf(const glm::dvec2& position, int cells)
{
    const glm::ivec2 cell = glm::clamp(
        glm::ivec2(glm::floor(position * static_cast<double>(cells))), glm::ivec2(0), glm::ivec2(cells - 1));
    return cell.y * cells + cell.x;
}

}

TEST_CASE("All rays of a pixel start at the camera and pass through the pixel", "[render]")
{
    const Generate generate = GENERATE(generatePixelRaysUniform, generatePixelRaysStratified);
    World world({}, { .numPixelSamples = 9 });
    const Trackball camera = makeCamera();
    Random random(1, "pixels");
    for (int i = 0; i < 200; ++i) {
        const glm::ivec2 pixel { random.integer(0, resolution.x - 1), random.integer(0, resolution.y - 1) };
        for (const Ray& ray : generate(world.state, camera, pixel, resolution)) {
            const glm::dvec2 inPixel = positionOf(camera, ray) - glm::dvec2(pixel);
            CHECK(glm::all(glm::greaterThan(inPixel, glm::dvec2(-pixelRounding))));
            CHECK(glm::all(glm::lessThan(inPixel, glm::dvec2(1.0 + pixelRounding))));
            CHECK(ray.origin == camera.position());
            CHECK(ray.t == FLT_MAX);
        }
    }
}

TEST_CASE("Uniform sampling gives the number of rays that was asked for", "[render]")
{
    for (const uint32_t count : { 1u, 2u, 3u, 7u, 16u, 101u })
        CHECK(positionsInPixel(generatePixelRaysUniform, count, 1).size() == count);
}

TEST_CASE("Stratified sampling gives n x n rays, n the rounded root", "[render]")
{
    const std::array<std::pair<uint32_t, std::size_t>, 8> counts { { { 1, 1 }, { 2, 1 }, { 3, 4 }, { 4, 4 }, { 6, 4 },
        { 7, 9 }, { 16, 16 }, { 100, 100 } } };
    for (const auto& [asked, expected] : counts)
        CHECK(positionsInPixel(generatePixelRaysStratified, asked, 1).size() == expected);
}

TEST_CASE("Stratified sampling puts one ray in each cell", "[render]")
{
    for (int n = 1; n <= 5; ++n) {
        const auto positions = positionsInPixel(generatePixelRaysStratified, static_cast<uint32_t>(n * n), 100);
        for (std::size_t first = 0; first < positions.size(); first += static_cast<std::size_t>(n * n)) {
            std::vector<int> counts(static_cast<std::size_t>(n * n));
            int onBorder = 0; // may be rounded into the next cell
            for (std::size_t i = first; i < first + counts.size(); ++i) {
                const glm::dvec2 inCell = glm::fract(positions[i] * static_cast<double>(n));
                onBorder += glm::any(glm::greaterThan(glm::abs(inCell - 0.5), glm::dvec2(0.5 - n * pixelRounding)));
                ++counts[static_cast<std::size_t>(cellOf(positions[i], n))];
            }
            CHECK(std::ranges::count(counts, 1) >= n * n - 2 * onBorder);
        }
    }
}

TEST_CASE("Rays are spread evenly over the pixel, and randomly", "[render]")
{
    // A fair sampler fails with a probability of 6e-7 for each seed, and the seed is fixed.
    constexpr double fiveDeviations = 5.0;
    for (const Generate generate : { Generate(generatePixelRaysUniform), Generate(generatePixelRaysStratified) }) {
        // One ray for each stratified cell of a call makes counts of whole cells too even: cells of 1 / 7 cut across.
        std::vector<int> counts(49);
        const uint32_t numSamples = generate == Generate(generatePixelRaysUniform) ? 5 : 1;
        for (const glm::dvec2& position : positionsInPixel(generate, numSamples, 5000))
            ++counts[static_cast<std::size_t>(cellOf(position, 7))];
        CHECK(std::abs(grading::unevenness(counts)) < fiveDeviations);
    }
    std::vector<int> inCells(49); // where in its cell of 4 x 4 a stratified ray goes
    for (const glm::dvec2& position : positionsInPixel(generatePixelRaysStratified, 16, 1000))
        ++inCells[static_cast<std::size_t>(cellOf(glm::fract(position * 4.0), 7))];
    CHECK(std::abs(grading::unevenness(inCells)) < fiveDeviations);
}

TEST_CASE("Stratified sampling finds an edge with less noise than uniform sampling", "[render]")
{
    const auto variance = [](Generate generate) {
        double sum = 0.0;
        constexpr int calls = 300;
        const auto positions = positionsInPixel(generate, 16, calls);
        for (std::size_t first = 0; first < positions.size(); first += 16) {
            const auto isLeft = [](const glm::dvec2& p) { return p.x + 0.5 * p.y < 0.7; };
            const auto count = std::count_if(positions.begin() + static_cast<std::ptrdiff_t>(first),
                positions.begin() + static_cast<std::ptrdiff_t>(first) + 16, isLeft);
            const double error = static_cast<double>(count) / 16.0 - 0.45; // the area left of the edge: 0.7 - 0.25
            sum += error * error / calls;
        }
        return sum;
    };
    // The edge crosses 6 of 16 cells: at least half of the variance goes.
    CHECK(variance(generatePixelRaysStratified) < 0.5 * variance(generatePixelRaysUniform));
}

TEST_CASE("The features select the sampling, and one sample goes through the centre", "[render]")
{
    World world;
    const Trackball camera = makeCamera();
    const auto generate = [&] { return generatePixelRays(world.state, camera, { 3, 4 }, resolution); };
    REQUIRE(generate().size() == 1);
    CHECK(glm::distance(positionOf(camera, generate().front()), glm::dvec2(3.5, 4.5)) < pixelRounding);
    world.features.numPixelSamples = 7;
    CHECK(generate().size() == 7);
    world.features.enableJitteredSampling = true;
    CHECK(generate().size() == 9);
}
