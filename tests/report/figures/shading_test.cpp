// What the figures of shading must show.
#include "report/made.h"
#include <catch2/catch.hpp>
#include <cmath>

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

TEST_CASE("Slider, legend, bar and lobes are there as pictures, and plots as vector drawings too", "[report]")
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
    for (const json& one : report_test::figures("reference"))
        for (const json& panel : one.at("panels"))
            if (panel.contains("svg"))
                CHECK(std::filesystem::exists(report_test::madeReport("reference") / "figures" / panel.at("svg")));
}
