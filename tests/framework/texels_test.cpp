#include "debug/texels.h"
#include "texture.h"
#include <catch2/catch.hpp>
#include <map>

// Which texels a function takes is found out by asking it.

namespace {

std::map<std::pair<int, int>, float> weightsOf(
    const debug::SampleTexture& sample, glm::ivec2 size, const glm::vec2& texCoord)
{
    std::map<std::pair<int, int>, float> weights;
    for (const debug::Texel& texel : debug::texelsOf(sample, size, texCoord))
        weights[{ texel.index.x, texel.index.y }] += texel.weight;
    return weights;
}

}

TEST_CASE("A nearest lookup takes one texel", "[texels]")
{
    const auto weights = weightsOf(sampleTextureNearest, { 7, 5 }, { 3.4f / 7.0f, 4.9f / 5.0f });
    REQUIRE(weights.size() == 1);
    CHECK(weights.at({ 3, 4 }) == 1.0f);
}

TEST_CASE("A bilinear lookup takes four, by the areas that face them", "[texels]")
{
    const auto weights = weightsOf(sampleTextureBilinear, { 64, 16 }, { 10.75f / 64.0f, 3.0f / 16.0f });
    REQUIRE(weights.size() == 4);
    const double rounding = 1e-4; // of coordinates of 64 texels
    CHECK(weights.at({ 10, 2 }) == Approx(0.375).margin(rounding));
    CHECK(weights.at({ 10, 3 }) == Approx(0.375).margin(rounding));
    CHECK(weights.at({ 11, 2 }) == Approx(0.125).margin(rounding));
    CHECK(weights.at({ 11, 3 }) == Approx(0.125).margin(rounding));
}

TEST_CASE("A function that looks where it should not is told on", "[texels]")
{
    const auto corners = [](const Image& image, const glm::vec2&) {
        return 0.5f * image.get_pixel(0) + 0.5f * image.get_pixel(image.width * image.height - 1);
    };
    const auto weights = weightsOf(corners, { 33, 9 }, { 0.5f, 0.5f });
    REQUIRE(weights.size() == 2);
    CHECK(weights.at({ 0, 0 }) == 0.5f);
    CHECK(weights.at({ 32, 8 }) == 0.5f);
}
