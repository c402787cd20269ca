// What the figures of lights and shadows must show.
#include "files/text.h"
#include "report/made.h"
#include "report/statistics.h"
#include <catch2/catch.hpp>
#include <random>
#include <set>

using nlohmann::json;
using report_test::checkClaims, report_test::figure;

namespace {

std::vector<glm::vec2> randomPoints(uint32_t seed, std::size_t count)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> coordinate;
    std::vector<glm::vec2> points(count);
    for (glm::vec2& point : points)
        point = { coordinate(random), coordinate(random) };
    return points;
}

}

TEST_CASE("Each kind of light is shown by the submission beside the reference, whose own pictures agree", "[report]")
{
    const json drawn = figure("light.kinds");
    REQUIRE(drawn.at("panels").size() == 3);
    std::set<std::string> pictures;
    for (const char* kind : { "point", "segment", "parallelogram" })
        CHECK(drawn.at("data").at(kind) == 0.0);
    for (const json& slider : drawn.at("panels"))
        for (const char* side : { "before", "after" })
            pictures.insert(files::readText(
                report_test::madeReport("reference") / "figures" / slider.at(side).at("png").get<std::string>()));
    CHECK(pictures.size() == 3); // of each kind two that are the same
}

TEST_CASE("Soft shadows have intermediate values, where hard ones have none", "[report]")
{
    const json drawn = figure("light.hard_and_soft");
    checkClaims(drawn);
    const json penumbra = drawn.at("data").at("penumbra");
    CHECK(penumbra[0] == 0);
    CHECK(penumbra[1] > 1000);
    CHECK(penumbra[2] > 1000);
    const auto numBetween = [](const char* kind) {
        const auto rows = report_test::plottedRows("light.hard_and_soft", 2, kind);
        return std::ranges::count_if(rows, [](const auto& row) { return row[1] > 0.02 && row[1] < 0.98; });
    };
    CHECK(numBetween("point") == 0);
    CHECK(numBetween("segment") > 20); // pixels of the row
    CHECK(numBetween("parallelogram") > 20);
}

TEST_CASE("Four times as many samples of a light halve the noise of a picture", "[report]")
{
    const json drawn = figure("light.noise");
    checkClaims(drawn);
    const auto errors = drawn.at("data").at("errors").get<std::vector<double>>();
    REQUIRE(errors.size() == 4);
    for (std::size_t i = 1; i < errors.size(); ++i)
        CHECK(errors[i - 1] / errors[i] == Approx(2.0).epsilon(0.1)); // 10,800 pixels, most of them in no half-shadow
}

TEST_CASE("The 1D sampler twice and the 2D sampler give samples that cannot be told apart", "[report]")
{
    const json drawn = figure("light.samples");
    checkClaims(drawn);
    CHECK(drawn.at("data").at("p") > 0.01);
    CHECK(drawn.at("data").at("number") == json { 2000, 2000 });
    for (const int panel : { 1, 2 })
        for (const char* edge : { "first", "second" }) {
            double number = 0.0, farthest = 0.0;
            for (const auto& bar : report_test::plottedRows("light.samples", panel, edge)) {
                number += bar[1];
                farthest = std::max(farthest, std::abs(bar[1] - 100.0));
            }
            CHECK(number == 2000.0);
            CHECK(farthest < 50.0); // of a twentieth of 2000, whose deviation is 10
        }
    CHECK(report_test::plottedRows("light.samples", 1, "samples")
        != report_test::plottedRows("light.samples", 2, "samples"));
}

TEST_CASE("The p-value of two sets of points is small if one is clumped, and anything if they are alike", "[report]")
{
    const std::vector<glm::vec2> even = randomPoints(1, 2000);
    std::vector<glm::vec2> clumped = randomPoints(2, 2000);
    for (glm::vec2& point : clumped)
        point.x *= point.x;
    CHECK(report::pValueOfDifference(even, clumped, 8) < 1e-6);
    int numBelowHalf = 0, numBelowTenth = 0;
    for (uint32_t seed = 0; seed < 400; seed += 2) {
        const double p = report::pValueOfDifference(randomPoints(100 + seed, 2000), randomPoints(101 + seed, 2000), 8);
        numBelowHalf += p < 0.5;
        numBelowTenth += p < 0.1;
    }
    CHECK(std::abs(numBelowHalf - 100) < 28); // of 200, with a deviation of 7
    CHECK(std::abs(numBelowTenth - 20) < 17); // of 4.2
}

TEST_CASE("A point in the border of a shadow has shadow rays of both colours", "[report]")
{
    const json drawn = figure("light.shadow_rays");
    checkClaims(drawn);
    const int green = drawn.at("data").at("green"), red = drawn.at("data").at("red");
    CHECK(green + red == 32); // one for each sample
    CHECK(green > 3);
    CHECK(red > 3);
}

TEST_CASE("The two formulas of transparent shadows are computed as they are written", "[report]")
{
    const json drawn = figure("light.formula");
    checkClaims(drawn);
    const json& data = drawn.at("data");
    const auto alphas = data.at("alpha").get<std::vector<double>>();
    const auto at = [&](const char* formula, double alpha) {
        const auto index = std::ranges::find(alphas, alpha) - alphas.begin();
        return data.at(formula).at(static_cast<std::size_t>(index)).get<double>();
    };
    constexpr double kd = 0.3;
    const auto nearly = [](double value) { return Approx(value).margin(1e-6); }; // a few roundings of floats
    CHECK(at("old", 0.0) == nearly(kd));
    CHECK(at("old", 0.5) == nearly(0.5 * kd));
    CHECK(at("old", 1.0) == 0.0);
    CHECK(at("proposed", 0.0) == nearly(1.0));
    CHECK(at("proposed", 0.5) == nearly(0.5 + 0.5 * kd));
    CHECK(at("proposed", 1.0) == 0.0); // the exception
    for (const char* formula : { "old", "proposed" }) {
        const auto rows = report_test::plottedRows("light.formula", 1, formula);
        REQUIRE(rows.size() == alphas.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            CHECK(rows[i][0] == nearly(static_cast<double>(alphas[i])));
            CHECK(rows[i][1] == nearly(data.at(formula).at(i)));
        }
    }
    CHECK(data.at("proposed").at(alphas.size() - 2).get<double>() == Approx(kd).margin(0.01)); // just before it
}

TEST_CASE("The table of the formulas answers what each leaves at alpha 0, 0.5 and 1", "[report]")
{
    const json table = figure("light.formula").at("panels").at(1);
    REQUIRE(table.at("kind") == "table");
    CHECK(table.at("rows")
        == json { { "0", "1", "0.3", "1", "0.3", "1" }, { "0.5", "0.5", "0.15", "0.65", "0.65", "0.325" },
            { "1", "0", "0", "0.3", "1", "0" } });
}

TEST_CASE("Both formulas are rendered, and differ", "[report]")
{
    const json drawn = figure("light.transparent_shadows");
    CHECK(drawn.at("data").at("proposed_is_own") == true);
    for (const double gap : drawn.at("data").at("gaps"))
        CHECK(gap > 0.02);
}

TEST_CASE("Figures of lights say what the stubs have not written", "[report]")
{
    for (const char* name : { "light.kinds", "light.hard_and_soft", "light.noise", "light.samples", "light.shadow_rays",
             "light.transparent_shadows", "light.formula" }) {
        const json drawn = figure(name, "student");
        INFO(name);
        CHECK(drawn.at("state") == "not written");
        CHECK(drawn.at("message").get<std::string>().find("Light") != std::string::npos);
    }
}
