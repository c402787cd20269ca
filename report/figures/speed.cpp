// What `raywork bench` measured of the library.
#include "report/figure.h"
#include "report/studio.h"
#include <fmt/format.h>

namespace report::speed {
namespace {

    using nlohmann::json;

    std::vector<std::string> cellsOf(const json& row)
    {
        return { row.at("model").get<std::string>(), row.at("rays").get<std::string>(),
            row.at("rival").get<std::string>(), fmt::format("{:.2f}", row.at("mrays_per_second").get<double>()),
            fmt::format("{:.2f} ({:.2f} to {:.2f})", row.at("ratio").get<double>(), row.at("least_ratio").get<double>(),
                row.at("most_ratio").get<double>()),
            fmt::format("{:.3f}", row.at("build_seconds").get<double>()) };
    }

    Sheet drawTraversal(Studio& studio)
    {
        const json report = studio.result("bench_traversal.json");
        Table table { "Ratios are of our rate to that row's",
            { "model", "rays", "by", "million a second", "ratio", "build, s" }, {} };
        for (const json& row : report.at("rows"))
            table.rows.push_back(cellsOf(row));
        Sheet sheet;
        sheet.columns = 1;
        sheet.panels = { std::move(table) };
        for (const auto& [rival, means] : report.at("geomean").items())
            for (const auto& [rays, mean] : means.items())
                sheet.facts.push_back(
                    { fmt::format("{}, {}", rival, rays), fmt::format("{:.2f}", mean.get<double>()) });
        return sheet;
    }

    const Figure traversal(
        "speed.traversal", "Rays that the library traces", drawTraversal, { "bench_traversal.json" });

}
}
