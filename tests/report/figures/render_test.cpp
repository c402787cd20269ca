// What the figures of multisampling must show.
#include "report/made.h"
#include "report/statistics.h"
#include <catch2/catch.hpp>

using nlohmann::json;
using report_test::checkClaims, report_test::figure;

namespace {

std::vector<glm::vec2> pointsOf(const json& rows)
{
    std::vector<glm::vec2> points;
    for (const json& row : rows)
        points.emplace_back(row[0].get<float>(), row[1].get<float>());
    return points;
}

}

TEST_CASE("The grid of stratified rays has 25 points, one a cell, and uniform ones leave cells empty", "[report]")
{
    const json drawn = figure("multisampling.grid");
    checkClaims(drawn);
    const auto uniform = pointsOf(drawn.at("data").at("uniform"));
    const auto stratified = pointsOf(drawn.at("data").at("stratified"));
    REQUIRE(uniform.size() == 25);
    REQUIRE(stratified.size() == 25);
    for (const glm::vec2& point : uniform) {
        CHECK((point.x >= 0.0f && point.x < 1.0f));
        CHECK((point.y >= 0.0f && point.y < 1.0f));
    }
    CHECK(report::countCells(stratified, 5) == std::vector<int>(25, 1));
    CHECK(report::countCells(pointsOf(report_test::plottedRows("multisampling.grid", 2, "own")), 5)
        == std::vector<int>(25, 1));
    CHECK(pointsOf(report_test::plottedRows("multisampling.grid", 1, "own")) == uniform);
    CHECK(report::countCells(uniform, 5) != std::vector<int>(25, 1));
}

TEST_CASE("Dispersion is 0 for equal counts, and grows with clumps", "[report]")
{
    CHECK(report::dispersion(std::vector { 3, 3, 3 }) == 0.0);
    CHECK(report::dispersion(std::vector { 0, 2, 4 }) == Approx(4.0 / 3.0)); // variance 8/3, mean 2
    CHECK(report::dispersion(std::vector { 0, 0, 9 }) == Approx(6.0));
}

TEST_CASE("16 stratified rays err less than 16 uniform ones, and these less than one", "[report]")
{
    const json drawn = figure("multisampling.pictures");
    checkClaims(drawn);
    const double one = drawn.at("data").at("one"), uniform = drawn.at("data").at("uniform"),
                 stratified = drawn.at("data").at("stratified");
    CHECK(uniform < 0.5 * one);
    CHECK(stratified < 0.7 * uniform);
    CHECK(drawn.at("panels").size() == 6); // with a magnified crop each
}

TEST_CASE("With eight rays the difference of uniform exceeds stratified, even with a ninth", "[report]")
{
    const json drawn = figure("multisampling.difference");
    checkClaims(drawn);
    const json& data = drawn.at("data");
    CHECK(data.at("uniform8").get<double>() > data.at("uniform9").get<double>());
    CHECK(data.at("uniform9").get<double>() > data.at("stratified").get<double>());
    CHECK(drawn.at("claims").at(0).at("text").get<std::string>().find("9 rays where 8 are asked") != std::string::npos);
}

TEST_CASE("The error falls by the square root of uniform rays, and faster of stratified ones", "[report]")
{
    const json drawn = figure("multisampling.error");
    checkClaims(drawn);
    const json& slopes = drawn.at("data").at("slopes");
    CHECK(slopes[0].get<double>() == Approx(-0.5).margin(0.05)); // 2000 estimates a point
    CHECK(slopes[1].get<double>() == Approx(-0.75).margin(0.05));
    CHECK(drawn.at("panels").size() == 2);
}

TEST_CASE("Unjittered rays show rings on a zone plate that are not there, jittered ones noise", "[report]")
{
    const json drawn = figure("multisampling.zone_plate");
    checkClaims(drawn);
    const json& phantom = drawn.at("data").at("phantom");
    CHECK(phantom[0].get<double>() == Approx(std::sqrt(0.125)).epsilon(0.1)); // of a cosine's half, about grey
    CHECK(phantom[1].get<double>() == Approx(std::sqrt(0.125 / 16.0)).epsilon(0.2)); // of 16 independent points of it
}

TEST_CASE("An edge along the rows has few greys by unjittered rays, many by jittered ones", "[report]")
{
    const json drawn = figure("multisampling.edge");
    checkClaims(drawn);
    CHECK(drawn.at("data").at("greys")[0] == 3); // one, two or three of four rows
    CHECK(drawn.at("data").at("greys")[1] > 10);
}

TEST_CASE("Figures of multisampling say what the stubs have not written", "[report]")
{
    for (const char* name : { "multisampling.grid", "multisampling.pictures", "multisampling.difference",
             "multisampling.error", "multisampling.zone_plate", "multisampling.edge" }) {
        const json drawn = figure(name, "student");
        INFO(name);
        CHECK(drawn.at("state") == "not written");
        CHECK(drawn.at("message").get<std::string>().find("generatePixelRays") != std::string::npos);
    }
}
