// What the figures of shading must show.
#include "report/figures/drawn.h"
#include "report/made.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

using nlohmann::json;
using report_test::figure;

TEST_CASE("The colour bar runs from light behind the surface to light in front of it, without a jump", "[report]")
{
    const json rows = figure("shading.color_bar").at("data").at("rows");
    REQUIRE(rows.size() == 201);
    CHECK(rows.front()[0] == -1.0);
    CHECK(rows.back()[0] == 1.0);
    for (std::size_t i = 1; i < rows.size(); ++i)
        for (std::size_t channel = 1; channel <= 3; ++channel) {
            constexpr double steepest = 2.0; // of the gradient's pieces, a unit of the cosine
            const double step = std::abs(rows[i][channel].get<double>() - rows[i - 1][channel].get<double>());
            CHECK(step <= steepest * 0.01 + 1e-5); // rounding
        }
    CHECK(rows.back()[1].get<double>() > rows[100][1].get<double>() + 0.5); // it changes at all
}

TEST_CASE("A picture of the gradient has the bar's colours, from behind the light to facing it", "[report]")
{
    std::vector<glm::vec3> bar;
    const json colorBar = figure("shading.color_bar");
    for (const json& row : colorBar.at("data").at("rows"))
        bar.emplace_back(row[1].get<float>(), row[2].get<float>(), row[3].get<float>());
    const report::Sheet sheet = report_test::drawn("shading.gradient");
    const report::Picture& picture = report_test::panelOf<report::Slider>(sheet, 0).after;
    std::set<std::ptrdiff_t> seen; // of the bar
    float farthest = 0.0f;
    for (std::size_t i = 0; i < picture.pixels.size(); i += 7) { // some of each row of pixels
        if (picture.pixels[i] == glm::vec3(0.0f)) // nothing there
            continue;
        const auto gap = [&](const glm::vec3& color) { return glm::distance(color, picture.pixels[i]); };
        const auto nearest = std::ranges::min_element(bar, {}, gap);
        farthest = std::max(farthest, gap(*nearest));
        seen.insert(nearest - bar.begin());
    }
    CHECK(farthest < 0.015f); // half a step of the bar, where the gradient is steepest: 2.5 a unit of the cosine
    CHECK(seen.size() > 150); // of 201
}

TEST_CASE("The lobes are those of Phong and of Blinn and Phong", "[report]")
{
    const json rows = figure("shading.lobes").at("data").at("rows");
    REQUIRE(rows.size() == 181);
    for (const json& row : rows) {
        const double angle = row[0].get<double>() * M_PI / 180.0, light = 40.0 * M_PI / 180.0;
        const double phong = std::max(std::cos(angle + light), 0.0);
        const double blinn = std::max(std::cos((angle + light) / 2.0), 0.0); // half the angle, in one plane
        INFO(row[0]);
        CHECK(row[1].get<double>() == Approx(std::pow(phong, 10.0)).margin(1e-5)); // floats to the power of 40
        CHECK(row[2].get<double>() == Approx(std::pow(blinn, 10.0)).margin(1e-5));
        CHECK(row[3].get<double>() == Approx(std::pow(phong, 40.0)).margin(1e-5));
        CHECK(row[4].get<double>() == Approx(std::pow(blinn, 40.0)).margin(1e-5));
    }
}

TEST_CASE("The comparison shows Blinn-Phong's wider highlights, and nothing of Phong's", "[report]")
{
    const json data = figure("shading.comparison").at("data");
    CHECK(data.at("blinn_phong").get<double>() > 0.05);
    CHECK(data.at("phong").get<double>() < 0.01);
    CHECK(data.at("equal").get<double>() > 0.5);
}

TEST_CASE("Slider, legend, bar and lobes are there", "[report]")
{
    const auto kinds = [](const char* name) {
        json list = json::array();
        const json whole = figure(name);
        for (const json& panel : whole.at("panels"))
            list.push_back(panel.at("kind"));
        return list;
    };
    CHECK(kinds("shading.gradient") == json { "slider" });
    CHECK(kinds("shading.color_bar") == json { "plot" });
    CHECK(kinds("shading.comparison") == json { "slider", "plot" });
    CHECK(kinds("shading.lobes") == json { "plot" });
}

TEST_CASE("Every panel but a table is a picture, drawings and plots are vector drawings too", "[report]")
{
    const auto isThere = [](const json& file) {
        return std::filesystem::file_size(report_test::madeReport("reference") / "figures" / file) > 0;
    };
    for (const json& one : report_test::figures("reference"))
        for (const json& panel : one.at("panels")) {
            INFO(one.at("name"));
            const std::string kind = panel.at("kind");
            if (kind == "slider")
                CHECK((isThere(panel.at("before").at("png")) && isThere(panel.at("after").at("png"))));
            else if (kind != "table")
                CHECK(isThere(panel.at("png")));
            if (kind == "drawing" || kind == "plot")
                CHECK(isThere(panel.at("svg")));
        }
}
