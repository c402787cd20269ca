#include "../files/temporary_folder.h"
#include "bench/plot.h"
#include "files/error.h"
#include "files/text.h"
#include <catch2/catch.hpp>

namespace {

// Titles with what gnuplot might take for its own.
const std::vector<bench::PlotPanel> panels {
    { "it's an_edge", "samples", "error", { { "a 'quoted' {curve}", 0, { { 1.0, 1.0 }, { 100.0, 0.1 } } } } },
    { "smooth", "samples", "error", { { "", 1, { { 1.0, 2.0 }, { 10.0, 0.2 } } } } },
};

}

TEST_CASE("A plot is drawn as SVG and PNG, with its titles as they are", "[bench]")
{
    const files_test::TemporaryFolder folder;
    bench::plot(folder / "it's new", "plot", panels);
    const std::string svg = files::readText(folder / "it's new/plot.svg");
    CHECK(svg.find("an_edge") != std::string::npos);
    CHECK(svg.find("smooth") != std::string::npos);
    CHECK(files::readText(folder / "it's new/plot.png").starts_with("\x89PNG"));
}

TEST_CASE("A plot that gnuplot cannot draw is told in a line", "[bench]")
{
    const files_test::TemporaryFolder folder;
    CHECK_THROWS_AS(
        bench::plot(folder / "", "plot", { { "nothing", "x", "y", { { "empty", 0, {} } } } }), files::Error);
}
