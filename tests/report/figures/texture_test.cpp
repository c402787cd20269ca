#include "report/figures/drawn.h"
#include <catch2/catch.hpp>
#include <glm/common.hpp>
#include <glm/gtx/component_wise.hpp>
#include <regex>

using namespace report_test;
using report::Picture;
using report::Slider;

namespace {

// Between pixels side by side, in the middle of the picture.
float largestStep(const Picture& picture)
{
    float largest = 0.0f;
    forEachPixel(picture.size, [&](glm::ivec2 pixel, std::size_t i) {
        const bool isInside = pixel.x > picture.size.x / 4 && pixel.x < 3 * picture.size.x / 4
            && pixel.y > picture.size.y / 4 && pixel.y < 3 * picture.size.y / 4;
        if (isInside)
            largest = std::max(largest, glm::compMax(glm::abs(picture.pixels[i] - picture.pixels[i - 1])));
    });
    return largest;
}

// How many texels of a plot are outlined with a weight.
std::ptrdiff_t weightsIn(const report::Plot& plot)
{
    static const std::regex weight("set label '[01]\\.[0-9]{3}'");
    return std::distance(std::sregex_iterator(plot.script.begin(), plot.script.end(), weight), std::sregex_iterator());
}

// By the definition of bilinear weights: a texel's is the product of how near its centre is, each way.
void checkBilinear(const nlohmann::json& lookup)
{
    const double x = lookup["place"][0], y = lookup["place"][1];
    REQUIRE(lookup["texels"].size() == 4);
    for (const auto& texel : lookup["texels"]) {
        const double weight
            = (1.0 - std::abs(texel[0].get<double>() + 0.5 - x)) * (1.0 - std::abs(texel[1].get<double>() + 0.5 - y));
        CHECK(
            texel[2].get<double>() == Approx(weight).margin(1e-4)); // of floats, and an 8-bit image that is all or none
    }
}

}

TEST_CASE("Bilinear filtering takes the steps between texels", "[report]")
{
    const auto sheet = drawn("texture.bilinear");
    CHECK(brokenClaim(sheet) == "");
    for (const std::size_t slider : { 0u, 2u }) { // the picture that fills the screen, and a part of the cube
        const auto& [nearest, bilinear] = panelOf<Slider>(sheet, slider);
        CHECK(largestStep(nearest) > 0.1f);
        CHECK(largestStep(bilinear) < 0.3f * largestStep(nearest));
    }
}

TEST_CASE("A nearest lookup takes the texel that it lies in, a bilinear one the four around it", "[report]")
{
    const auto sheet = drawn("texture.lookup");
    CHECK(brokenClaim(sheet) == "");
    const auto& nearest = sheet.data["nearest"];
    REQUIRE(nearest["texels"].size() == 1);
    for (int axis = 0; axis < 2; ++axis)
        CHECK(nearest["texels"][0][axis] == std::floor(nearest["place"][axis].get<double>()));
    checkBilinear(sheet.data["bilinear"]);
    CHECK(weightsIn(panelOf<report::Plot>(sheet, 0)) == 1);
    CHECK(weightsIn(panelOf<report::Plot>(sheet, 1)) == 4);
    CHECK(sheet.data["bilinear"]["place"] == nearest["place"]);
    CHECK(sheet.data["bilinear"]["bounce"] == 0);
}

TEST_CASE("A texture that is seen in a mirror is looked up after the first turn", "[report]")
{
    const auto sheet = drawn("texture.secondary");
    CHECK(brokenClaim(sheet) == "");
    CHECK(sheet.data["bounce"] == 1);
    CHECK(weightsIn(panelOf<report::Plot>(sheet, 1)) == 4);
    checkBilinear(sheet.data);
}
