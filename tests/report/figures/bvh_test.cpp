#include "report/figures/drawn.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <sstream>

using namespace report_test;
using report::Drawing;
using report::Picture;

TEST_CASE("The boxes' colours go from yellow to red in the order visited", "[report]")
{
    const auto sheet = drawn("bvh.order");
    CHECK(brokenClaim(sheet) == "");
    std::map<std::size_t, std::vector<debug::Stroke>> shapes; // in the order drawn
    for (const debug::Stroke& stroke : panelOf<Drawing>(sheet, 0).strokes)
        shapes[stroke.shape].push_back(stroke);
    std::vector<glm::vec3> colors;
    for (const auto& [shape, strokes] : shapes)
        if (strokes.size() > 2) // edges of a box; the camera sees some of its twelve, and a ray is one stroke
            colors.push_back(strokes.front().color);
    REQUIRE(colors.size() > 5);
    CHECK(colors.front() == glm::vec3(1, 1, 0));
    CHECK(colors.back() == glm::vec3(1, 0, 0));
    for (std::size_t i = 1; i < colors.size(); ++i)
        CHECK(colors[i].y < colors[i - 1].y);
}

TEST_CASE("Of the triangles in a ray's way the first is drawn and no other", "[report]")
{
    const auto sheet = drawn("bvh.hit");
    CHECK(brokenClaim(sheet) == "");
    const auto t = sheet.data["t"].get<std::vector<float>>();
    REQUIRE(t.size() > 1);
    CHECK(t[0] < t[1]);
    CHECK(sheet.data["drawn"].get<std::vector<int>>() == std::vector { 1 });
    std::size_t filled = 0;
    for (const debug::Stroke& stroke : panelOf<Drawing>(sheet, 0).strokes)
        filled += stroke.isFilled;
    CHECK(filled == 1);
}

TEST_CASE("The heat map has a scale that holds all pixels, and few of the nodes are visited", "[report]")
{
    const auto sheet = drawn("bvh.heat");
    CHECK(brokenClaim(sheet) == "");
    const auto brightness = [](const glm::vec3& color) { return color.x + color.y + color.z; };
    const auto& pixels = panelOf<Picture>(sheet, 0).pixels;
    CHECK(brightness(std::ranges::max(pixels, {}, brightness)) > 3.0f * brightness(pixels.back())); // there is sky

    std::istringstream script { panelOf<report::Plot>(sheet, 2).script };
    double percent = 0.0;
    std::string line;
    while (std::getline(script, line) && line != "$bars << EOD") { }
    for (double nodes, share; script >> nodes >> share;)
        percent += share;
    CHECK(percent == Approx(100.0));
    CHECK(sheet.data["mean"].get<double>() < sheet.data["most"].get<double>());
    CHECK(sheet.data["mean"].get<double>() == Approx(sheet.data["reference mean"].get<double>()));
}

TEST_CASE("The table of trees counts triangles, levels and leaves that can be", "[report]")
{
    const auto sheet = drawn("bvh.table");
    const auto& table = panelOf<report::Table>(sheet, 0);
    REQUIRE(table.rows.size() == sheet.data.size());
    for (const auto& row : table.rows)
        CHECK(row.size() == table.head.size());
    for (const auto& tree : sheet.data) {
        const auto triangles = tree["triangles"].get<uint64_t>(), leaves = tree["leaves"].get<uint64_t>();
        CHECK(4 * leaves >= triangles); // as many as a leaf may hold
        CHECK(leaves <= triangles);
        CHECK(uint64_t(1) << (tree["levels"].get<uint64_t>() - 1) >= leaves);
    }
    CHECK(sheet.data.front()["triangles"] == 1);
    CHECK(sheet.data.back()["triangles"] > 100'000);
}

TEST_CASE(
    "The table of work counts what is done, says what is left out and why, in the same words for both", "[report]")
{
    const auto sheet = drawn("bvh.work");
    CHECK(brokenClaim(sheet) == "");
    const auto cells = [&](std::size_t panel, const std::string& what) {
        const auto& rows = panelOf<report::Table>(sheet, panel).rows;
        const auto row = std::ranges::find_if(rows, [&](const auto& each) { return each[0] == what; });
        REQUIRE(row != rows.end());
        return *row;
    };
    CHECK(cells(0, "rays from the camera")[1] == "30000");
    for (const auto& row : panelOf<report::Table>(sheet, 0).rows) { // the reference beside itself
        CHECK(row.at(1) == row.at(2));
        CHECK(row.at(3) == row.at(4));
    }
    CHECK(cells(0, "rays to lights, left out")[1] != "0");
    CHECK(cells(0, "textures looked up")[3] != "0");
    CHECK(cells(0, "textures decoded")[3] == "1 of 1");
    CHECK(cells(1, "spheres")[1] == "no: the scene has none");
    CHECK(cells(1, "triangles")[1] == "yes");
    CHECK(sheet.data["triangles"] > 0);
}
