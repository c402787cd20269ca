#include "debug/raster.h"
#include <catch2/catch.hpp>
#include <numeric>

// Drawing over a picture changes the pixels that it should, and by as much as is covered.

namespace {

constexpr glm::ivec2 size { 40, 30 };

float coveredArea(const debug::Stroke& stroke)
{
    std::vector<glm::vec3> pixels(static_cast<std::size_t>(size.x * size.y), glm::vec3(0.0f));
    debug::drawOver(pixels, size, { stroke });
    return std::accumulate(
        pixels.begin(), pixels.end(), 0.0f, [](float sum, const glm::vec3& pixel) { return sum + pixel.x; });
}

const glm::vec3 white { 1.0f };

}

TEST_CASE("A line covers its length times two pixels and its round ends", "[raster]")
{
    const glm::vec2 end = GENERATE(glm::vec2(30, 10), glm::vec2(10, 25), glm::vec2(25, 22));
    const float length = glm::distance(glm::vec2(10, 10), end);
    const float expected = 2.0f * length + 3.14159f;
    CHECK(coveredArea({ 0, { { 10, 10 }, end }, white, 1.0f, false }) == Approx(expected).epsilon(0.05));
}

TEST_CASE("An area covers as much as it has, whichever way round it is given", "[raster]")
{
    std::vector<glm::vec2> corners { { 5, 5 }, { 25, 7 }, { 12, 22 } };
    const float expected = 0.5f * (20.0f * 17.0f - 2.0f * 7.0f);
    CHECK(coveredArea({ 0, corners, white, 1.0f, true }) == Approx(expected).epsilon(0.03));
    std::swap(corners[0], corners[1]);
    CHECK(coveredArea({ 0, corners, white, 0.5f, true }) == Approx(0.5f * expected).epsilon(0.03));
}

TEST_CASE("What lies off the picture is no harm", "[raster]")
{
    CHECK(coveredArea({ 0, { { -1e6f, 15 }, { 1e6f, 15 } }, white, 1.0f, false }) == Approx(80.0f).epsilon(0.02));
    CHECK(coveredArea({ 0, { { 100, 100 }, { 120, 140 } }, white, 1.0f, false }) == 0.0f);
    CHECK(coveredArea({ 0, { { -10, -10 }, { -20, -10 }, { -15, -5 } }, white, 1.0f, true }) == 0.0f);
}
