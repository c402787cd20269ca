#include "report/figures/drawn.h"
#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <set>

using namespace report_test;
using report::Picture;
using report::Slider;

namespace {

const glm::vec3 black { 0.0f };

std::size_t countColors(const Picture& picture)
{
    std::set<std::array<float, 3>> colors;
    for (const glm::vec3& c : picture.pixels)
        colors.insert({ c.x, c.y, c.z });
    return colors.size();
}

}

TEST_CASE("Interpolated normals change a model's shades and leave its outline", "[report]")
{
    const auto sheet = drawn("interpolation.on_and_off");
    CHECK(brokenClaim(sheet) == "");
    const auto& [before, after] = panelOf<Slider>(sheet, 0);
    CHECK(before.pixels != after.pixels);
    CHECK(after.pixels == panelOf<Picture>(sheet, 1).pixels);
}

TEST_CASE("Pictures of normals hold unit vectors: a few of flat triangles, many interpolated", "[report]")
{
    const auto sheet = drawn("interpolation.normals");
    CHECK(brokenClaim(sheet) == "");
    const auto& [flat, smooth] = panelOf<Slider>(sheet, 0);
    for (const Picture* picture : { &flat, &smooth }) {
        float offUnit = 0.0f;
        for (const glm::vec3& color : picture->pixels)
            if (color != black)
                offUnit = std::max(offUnit, std::abs(glm::length(2.0f * color - 1.0f) - 1.0f));
        CHECK(offUnit < 1e-5f); // roundings of colours and back
    }
    CHECK(countColors(flat) < 1'000); // the model has fewer triangles
    CHECK(countColors(smooth) > 50'000);
}

TEST_CASE("Barycentric coordinates as colours have the sum 1 and reach each corner", "[report]")
{
    const auto sheet = drawn("interpolation.barycentric");
    CHECK(brokenClaim(sheet) == "");
    REQUIRE(sheet.panels.size() == 4);
    for (const std::size_t panel : { 0u, 2u }) {
        glm::vec3 highest { 0.0f };
        float offOne = 0.0f;
        for (const glm::vec3& color : panelOf<Picture>(sheet, panel).pixels)
            if (color != black) {
                offOne = std::max(offOne, std::abs(color.x + color.y + color.z - 1.0f));
                highest = glm::max(highest, color);
            }
        CHECK(offOne < 1e-6f); // roundings
        for (int corner = 0; corner < 3; ++corner)
            CHECK(highest[corner] > 0.98f); // a pixel near each corner, of hundreds along an edge
    }
}
