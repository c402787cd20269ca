// What the figures of other commands' measurements must show: all of their numbers.
#include "files/text.h"
#include "report/made.h"
#include <catch2/catch.hpp>
#include <fmt/format.h>

using nlohmann::json;
using report_test::figure;
using report_test::madeReport;
using report_test::scriptOf;

namespace {

json resultOf(const std::string& file)
{
    return json::parse(files::readText(madeReport("reference") / "../reference/report" / file));
}

}

TEST_CASE("Errors are plotted against samples and against time, each with its slope", "[report]")
{
    const json drawn = figure("accuracy.error"), result = resultOf("bench_error.json");
    int panel = 0;
    for (const auto& [integrand, strategies] : result.at("points").items())
        for (const std::string by : { "samples", "time" }) {
            CHECK(drawn.at("panels")[static_cast<std::size_t>(panel)].at("label") == integrand + ", by " + by);
            const std::string script = scriptOf("accuracy.error", ++panel);
            for (const auto& [strategy, points] : strategies.items()) {
                INFO(integrand << ", " << strategy);
                for (const json& point : points) {
                    const double samples = point.at("samples"), error = point.at("error"), time = point.at("seconds");
                    CHECK(script.find(fmt::format("\n{:.9g} {:.9g} {:.9g}\n", samples, error, 1e6 * time))
                        != std::string::npos);
                }
                const double slope = result.at("slope").at(integrand).at(strategy);
                CHECK(script.find(fmt::format("\"{}, slope {:.2f}\"", strategy, slope)) != std::string::npos);
            }
        }
    CHECK(drawn.at("panels").size() == static_cast<std::size_t>(panel));
}

TEST_CASE("Stress is plotted with the largest error of each feature", "[report]")
{
    const json drawn = figure("accuracy.stress");
    const std::string script = scriptOf("accuracy.stress", 1);
    CHECK(script.find("\ninterpolation 12.25 1000\nlight 37.5 2000\n") != std::string::npos);
    CHECK(drawn.at("claims").at(0).at("text") == "Of 3000 cases 0 failed.");
}

TEST_CASE("The table of the library's traversal has a row for each that was measured", "[report]")
{
    const json table = figure("speed.traversal").at("panels").at(0), rows = resultOf("bench_traversal.json").at("rows");
    REQUIRE(table.at("rows").size() == rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CHECK(table.at("rows")[i][0] == rows[i].at("model"));
        CHECK(table.at("rows")[i][2] == rows[i].at("rival"));
        CHECK(table.at("rows")[i][3] == fmt::format("{:.2f}", rows[i].at("mrays_per_second").get<double>()));
    }
}
