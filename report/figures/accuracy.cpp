// What other commands measured of a submission's accuracy.
#include "report/figure.h"
#include "report/plot.h"
#include "report/studio.h"
#include <fmt/format.h>

namespace report::accuracy {
namespace {

    using nlohmann::json;

    // Rows "samples error microseconds" of each strategy, as blocks named after it.
    std::string blocksOf(const json& strategies)
    {
        std::string blocks;
        for (const auto& [strategy, points] : strategies.items()) {
            std::vector<std::vector<double>> rows;
            for (const json& point : points)
                rows.push_back({ point.at("samples").get<double>(), point.at("error").get<double>(),
                    1e6 * point.at("seconds").get<double>() });
            blocks += dataBlock(strategy, rows);
        }
        return blocks;
    }

    // column: 1 samples, 3 microseconds. The curves' names say how steep they are.
    std::string curvesOf(const json& strategies, const json& slopes, int column)
    {
        std::string curves;
        int style = 0;
        for (const auto& [strategy, points] : strategies.items()) {
            ++style;
            curves += fmt::format("{}${} using {}:2 with linespoints linetype {} title \"{}, slope {:.2f}\", "
                                  "${} using {}:2:(sprintf(\"{}: %g samples, error %.2e, %.3g µs\", $1, $2, $3)) "
                                  "with labels hypertext point linetype {} pointsize 0.4 notitle",
                style > 1 ? ", " : "plot ", strategy, column, style, strategy, slopes.at(strategy).get<double>(),
                strategy, column, strategy, style);
        }
        return curves + "\n";
    }

    Plot errorPlot(const json& report, const std::string& integrand, int column)
    {
        const json& strategies = report.at("points").at(integrand);
        return { fmt::format("{}, by {}", integrand, column == 1 ? "samples" : "time"),
            blocksOf(strategies)
                + fmt::format(
                    "set logscale xy\nset format y \"10^{{%T}}\"\nset xlabel \"{}\"\nset ylabel \"RMS error\"\n"
                    "set key left bottom\n",
                    column == 1 ? "samples" : "microseconds an estimate")
                + curvesOf(strategies, report.at("slope").at(integrand), column),
            { 520, 360 } };
    }

    Sheet drawErrors(Studio& studio)
    {
        const json report = studio.result("bench_error.json");
        Sheet sheet;
        for (const auto& [integrand, strategies] : report.at("points").items()) {
            sheet.panels.emplace_back(errorPlot(report, integrand, 1));
            sheet.panels.emplace_back(errorPlot(report, integrand, 3));
            const json& slope = report.at("slope").at(integrand);
            sheet.claims.push_back(
                { fmt::format("{}: with independent samples the error falls with their number to the "
                              "power of {:.2f}, with stratified ones {:.2f}.",
                      integrand, slope.at("uniform").get<double>(), slope.at("stratified").get<double>()),
                    slope.at("stratified").get<double>() < slope.at("uniform").get<double>() });
        }
        sheet.data = report.at("slope");
        return sheet;
    }

    Sheet drawStress(Studio& studio)
    {
        const json report = studio.result("stress.json");
        std::string rows = "$stress << EOD\n";
        for (const auto& [feature, sum] : report.at("features").items())
            rows += fmt::format("{} {:.6g} {}\n", feature, sum.at("largest_error_ulps").get<double>(),
                sum.at("cases").get<std::size_t>());
        Sheet sheet;
        sheet.columns = 1;
        sheet.panels = { Plot { "The largest error of each feature, in units in the last place", rows + R"plot(EOD
set boxwidth 0.5; set style fill solid 0.85 noborder; unset key; set ylabel "ulps"; set yrange [0:*]
plot $stress using 0:2:xtic(1) with boxes linetype 1, \
     $stress using 0:2:(sprintf("%s: %.3g ulps in %s cases", stringcolumn(1), $2, stringcolumn(3))) \
         with labels hypertext point linetype 1 pointsize 0.4
)plot",
            { 720, 280 } } };
        const auto cases = report.at("cases").get<std::size_t>(), failed = report.at("failed").get<std::size_t>();
        sheet.claims = { { fmt::format("Of {} cases {} failed.", cases, failed), failed == 0 } };
        sheet.facts = { { "seed", report.at("seed").dump() } };
        return sheet;
    }

    const Figure errors("accuracy.error", "What sampling errs, against the truth", drawErrors, { "bench_error.json" });
    const Figure stress("accuracy.stress", "The largest errors that stress found", drawStress, { "stress.json" });

}
}
