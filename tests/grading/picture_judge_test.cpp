#include "bvh.h"
#include "files/scene_file.h"
#include "grading/picture_judge.h"
#include "grading/probes/render_replicate.h"
#include "grading/tiles.h"
#include "recursive.h"
#include "render.h"
#include <catch2/catch.hpp>
#include <functional>
#include <random>

// The judge of pictures, on pictures whose truth is known.

namespace {

using grading::Judgement;
using grading::Replicates;
using Outcome = Judgement::Outcome;
using Engine = std::mt19937_64;

constexpr int width = 64; // pixels
constexpr int numReplicates = 32;
constexpr double significance = 1e-5;

// The colour of a pixel in one replicate.
using Pixel = std::function<float(glm::ivec2, Engine&)>;

Replicates replicatesOf(uint64_t seed, const Pixel& pixel, int size = width)
{
    Engine engine(seed);
    Replicates all { glm::ivec2(size), std::vector<glm::vec3>(static_cast<std::size_t>(size * size)), {} };
    for (int i = 0; i < numReplicates; ++i) {
        std::vector<glm::vec3> pixels;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                pixels.push_back(pixel({ x, y }, engine) * glm::vec3(1.0f, 0.7f, 0.5f));
                all.mean[pixels.size() - 1] += pixels.back() / static_cast<float>(numReplicates);
            }
        all.tiles.push_back(grading::tileMeans(pixels, all.size));
    }
    return all;
}

// Shades from 0.2 to 0.8 with the noise of a few light samples, and a part without any.
float noisy(glm::ivec2 pixel, Engine& engine)
{
    const float shade = 0.2f + 0.6f * static_cast<float>(pixel.x) / width;
    const bool isSmooth = pixel.y < width / 4;
    return isSmooth ? shade : shade * std::uniform_real_distribution(0.7f, 1.3f)(engine);
}

// A few pixels are bright, one replicate in twenty: their tiles have an effective size of about 2.
float withFireflies(glm::ivec2 pixel, Engine& engine)
{
    const bool isBright = pixel.x % 16 == 5 && pixel.y % 16 == 9 && std::bernoulli_distribution(0.05)(engine);
    return noisy(pixel, engine) + (isBright ? 200.0f : 0.0f);
}

// A log-normal of mean 1 whose values differ by powers of ten.
float heavyTailed(glm::ivec2, Engine& engine)
{
    constexpr float spread = 1.5f;
    return std::exp(std::normal_distribution(-spread * spread / 2.0f, spread)(engine));
}

bool isIn(glm::ivec2 pixel, glm::ivec2 corner, int size)
{
    const glm::ivec2 offset = pixel - corner;
    return offset.x >= 0 && offset.y >= 0 && offset.x < size && offset.y < size;
}

Outcome judge(const Pixel& came, const Pixel& expected, uint64_t seed, double chance = significance, int size = width)
{
    return judgePictures(replicatesOf(2 * seed, came, size), replicatesOf(2 * seed + 1, expected, size), chance)
        .outcome;
}

}

TEST_CASE("A picture brighter by one percent is different", "[picture_judge]")
{
    for (uint64_t seed = 0; seed < 20; ++seed) {
        const float factor = seed % 2 ? 1.01f : 0.99f;
        CHECK(judge([&](glm::ivec2 p, Engine& e) { return factor * noisy(p, e); }, noisy, seed) == Outcome::Different);
    }
}

TEST_CASE("A picture with a square of 32 x 32 pixels brighter by five percent is different", "[picture_judge]")
{
    for (const glm::ivec2 corner : { glm::ivec2(0, 0), { 32, 32 }, { 13, 7 }, { 31, 3 }, { 1, 29 }, { 20, 20 } })
        for (uint64_t seed = 0; seed < 5; ++seed) {
            CAPTURE(corner.x, corner.y, seed);
            const auto came
                = [&](glm::ivec2 p, Engine& e) { return noisy(p, e) * (isIn(p, corner, 32) ? 1.05f : 1.0f); };
            CHECK(judge(came, noisy, seed) == Outcome::Different);
        }
}

TEST_CASE("A picture with a black patch of 3 x 3 pixels is different, and the patch is found", "[picture_judge]")
{
    for (const glm::ivec2 corner : { glm::ivec2(0, 0), { 61, 61 }, { 33, 34 }, { 6, 14 }, { 31, 31 }, { 22, 39 } })
        for (uint64_t seed = 0; seed < 5; ++seed) {
            CAPTURE(corner.x, corner.y, seed);
            const auto came
                = [&](glm::ivec2 p, Engine& e) { return isIn(p, corner, 3) ? 0.0f * noisy(p, e) : noisy(p, e); };
            const Judgement judgement
                = judgePictures(replicatesOf(2 * seed, came), replicatesOf(2 * seed + 1, noisy), significance);
            CHECK(judgement.outcome == Outcome::Different);
            CHECK(glm::all(glm::lessThanEqual(glm::abs(judgement.worst - corner - 1), glm::ivec2(4))));
        }
}

TEST_CASE("Pictures that differ by chance alone are never different", "[picture_judge]")
{
    const Pixel pixel = GENERATE(Pixel(noisy), Pixel(withFireflies), Pixel(heavyTailed));
    for (uint64_t seed = 0; seed < 300; ++seed)
        CHECK(judge(pixel, pixel, seed, significance, width / 2) != Outcome::Different);
}

TEST_CASE("Pictures that differ by what is allowed are different no more often than stated", "[picture_judge]")
{
    // Every tile of 8 x 8 pixels is brighter by nearly what is allowed there and more than allowed nowhere: no other
    // right solution is in greater danger. Single values vary so much that the tails of their means are not normal.
    constexpr double chance = 0.2;
    constexpr int numRepetitions = 300;
    const auto came = [](glm::ivec2 p, Engine& e) {
        const bool isBrighter = (p.x / 8 + p.y / 8) % 2 == 0;
        return heavyTailed(p, e) * (isBrighter ? 1.029f : 0.971f);
    };
    int numDifferent = 0; // 2 when this was written
    for (uint64_t seed = 0; seed < numRepetitions; ++seed)
        numDifferent += judge(came, heavyTailed, seed, chance, width / 2) == Outcome::Different;
    // Four standard deviations of a count above its mean.
    CHECK(numDifferent <= chance * numRepetitions + 4.0 * std::sqrt(chance * numRepetitions));
}

TEST_CASE("Heavy tails do not hide a mean that is a fifth too large", "[picture_judge]")
{
    for (uint64_t seed = 0; seed < 20; ++seed) {
        const auto came = [](glm::ivec2 p, Engine& e) { return 1.2f * heavyTailed(p, e); };
        CHECK(judge(came, heavyTailed, seed) == Outcome::Different);
    }
}

TEST_CASE("A wrong picture does not hide in noise", "[picture_judge]")
{
    const auto amplitude = GENERATE(1.0f, 30.0f, 1e5f);
    const auto came = [&](glm::ivec2 p, Engine& e) {
        return 0.8f * noisy(p, e) + amplitude * std::uniform_real_distribution<float>(-1.0f, 1.0f)(e);
    };
    for (uint64_t seed = 0; seed < 5; ++seed)
        CHECK(judge(came, noisy, seed) == Outcome::Different);
}

TEST_CASE("A tile that rare bright pixels light is not compared", "[picture_judge]")
{
    // Too little light to count in the whole picture.
    const auto flashing = [](double probability) -> Pixel {
        return [=](glm::ivec2 p, Engine& e) {
            const bool isBright = p == glm::ivec2(13, 50) && std::bernoulli_distribution(probability)(e);
            return isBright || p.x >= width / 2 ? 1.0f : 0.0f;
        };
    };
    CHECK(judge(flashing(0.9), flashing(0.1), 1) == Outcome::Same);
    CHECK(judge(flashing(0.0), flashing(0.9), 1) == Outcome::Different);
}

TEST_CASE("What is too noisy to tell is undecided, and more samples decide it", "[picture_judge]")
{
    const auto brightness = GENERATE(1.0f, 1.06f);
    // The mean of numSamples values, none or one each, in one tile.
    const auto withNoise = [](float mean, int numSamples) -> Pixel {
        return [=](glm::ivec2 p, Engine& e) {
            if (!isIn(p, { 24, 24 }, 8))
                return 0.5f;
            return mean * static_cast<float>(std::binomial_distribution(numSamples, 0.5)(e))
                / static_cast<float>(numSamples);
        };
    };
    CHECK(judge(withNoise(brightness, 1), withNoise(1.0f, 1), 1) == Outcome::Undecided);
    CHECK(judge(withNoise(brightness, 1000), withNoise(1.0f, 1000), 1)
        == (brightness == 1.0f ? Outcome::Same : Outcome::Different));
}

TEST_CASE("Where nothing varies, what is allowed decides alone", "[picture_judge]")
{
    const auto plain = [](float value) -> Pixel { return [=](glm::ivec2, Engine&) { return value; }; };
    CHECK(judge(plain(0.5f), plain(0.5f), 1) == Outcome::Same);
    CHECK(judge(plain(0.5f + 1e-6f), plain(0.5f), 1) == Outcome::Same);
    CHECK(judge(plain(0.505f), plain(0.5f), 1) == Outcome::Different);
    CHECK(judge(plain(0.0f), plain(0.0f), 1) == Outcome::Same);
}

TEST_CASE("One picture for every seed is told apart from a wrong one", "[picture_judge]")
{
    const auto striped = [](glm::ivec2 p, Engine&) { return p.x % 2 ? 0.4f : 0.6f; };
    const Judgement judgement = judgePictures(replicatesOf(0, striped), replicatesOf(1, noisy), significance);
    CHECK(judgement.outcome == Outcome::Different);
    CHECK_THAT(judgement.came, Catch::Contains("the same picture for every seed"));
    // A black one has nothing that could vary.
    const auto black = [](glm::ivec2, Engine&) { return 0.0f; };
    CHECK_THAT(judgePictures(replicatesOf(0, black), replicatesOf(1, noisy), significance).came,
        !Catch::Contains("seed") && Catch::Contains("a mean of 0.0"));
}

TEST_CASE("A colour that is no number is different, wherever it is", "[picture_judge]")
{
    const float value = GENERATE(NAN, INFINITY, -INFINITY);
    const glm::ivec2 place = GENERATE(glm::ivec2(0, 0), glm::ivec2(63, 63), glm::ivec2(17, 42));
    const Judgement judgement
        = judgePictures(replicatesOf(0, [&](glm::ivec2 p, Engine& e) { return p == place ? value : noisy(p, e); }),
            replicatesOf(1, noisy), significance);
    CHECK(judgement.outcome == Outcome::Different);
    CHECK_THAT(judgement.came, Catch::Contains("no number"));
    CHECK(judgement.worst == place);
}

TEST_CASE("A worker that hides its broken pixels in the mean is found by its tiles", "[picture_judge]")
{
    Replicates came = replicatesOf(0, noisy);
    came.tiles[7][100].g = NAN;
    CHECK(judgePictures(came, replicatesOf(1, noisy), significance).outcome == Outcome::Different);
}

TEST_CASE("A picture of another size is different", "[picture_judge]")
{
    const Replicates expected = replicatesOf(1, noisy);
    const Judgement judgement = judgePictures(replicatesOf(0, noisy, 48), expected, significance);
    CHECK(judgement.outcome == Outcome::Different);
    CHECK(judgement.came == "a picture of 48 x 48 pixels");
    CHECK(judgement.expected == "64 x 64");

    // Nor may a worker send what does not fit the size that it states.
    for (const auto& spoil : std::vector<std::function<void(Replicates&)>> { [](Replicates& r) { r.tiles.pop_back(); },
             [](Replicates& r) { r.tiles[3].pop_back(); }, [](Replicates& r) { r.mean.pop_back(); },
             [](Replicates& r) { r = {}; } }) {
        Replicates spoilt = replicatesOf(0, noisy);
        spoil(spoilt);
        CHECK(judgePictures(spoilt, expected, significance).outcome == Outcome::Different);
    }
}

namespace {

// Which random numbers a pixel gets: its own, the next ones of its row's, or those that all pixels of its row get.
enum class Stream { OfPixel, OfRow, SameInRow };

// Soft shadows, by a right renderer.
Replicates renderSoftly(uint32_t seed, Stream stream)
{
    auto [scene, config] = files::loadSceneFile(RAYWORK_SCENES "/soft_shadows.toml");
    config.features.numPixelSamples = 4;
    config.features.numShadowSamples = 2;
    config.features.enableJitteredSampling = true;
    config.size = glm::ivec2(width);
    const BVH bvh { scene, config.features };
    const Trackball camera = makeTrackball(config);
    RenderState state { scene, config.features, bvh, Sampler(seed) };
    Sampler row = state.sampler;
    return replicatesOf(seed, [&](glm::ivec2 pixel, Engine& engine) {
        if (stream == Stream::OfPixel || pixel.x == 0)
            row = Sampler(static_cast<uint32_t>(engine()));
        if (stream != Stream::OfRow || pixel.x == 0)
            state.sampler = row;
        return renderRays(state, generatePixelRays(state, camera, pixel, config.size)).g;
    });
}

}

TEST_CASE("A right renderer is not different, whatever its random numbers", "[picture_judge]")
{
    const auto stream = GENERATE(Stream::OfPixel, Stream::OfRow, Stream::SameInRow);
    const Replicates expected = renderSoftly(1000, Stream::OfPixel);
    for (uint32_t seed = 0; seed < 5; ++seed)
        CHECK(judgePictures(renderSoftly(seed, stream), expected, significance).outcome != Outcome::Different);
}
