#include "bench/error_report.h"
#include <algorithm>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace bench {
namespace {

    constexpr double errorsToReach[] = { 0.1, 0.03, 0.01, 0.003, 0.001, 0.0003 };

    double errorAt(uint32_t numSamples, const ErrorCurve& curve)
    {
        return std::ranges::find(curve.points, numSamples, &ErrorPoint::numSamples)->error;
    }

    nlohmann::json toJson(const std::vector<ErrorPoint>& points)
    {
        nlohmann::json rows = nlohmann::json::array();
        for (const ErrorPoint& p : points)
            rows.push_back(
                { { "samples", p.numSamples }, { "error", p.error }, { "mean", p.mean }, { "seconds", p.seconds } });
        return rows;
    }

    nlohmann::json timesOf(const ErrorCurve& curve)
    {
        nlohmann::json times = nlohmann::json::object();
        for (const double error : errorsToReach)
            if (const std::optional<double> seconds = secondsToReach(error, curve.points))
                times[fmt::format("{}", error)] = *seconds;
        return times;
    }

}

void printErrorHeader()
{
    fmt::print("{:<12} {:<11} {:>9} {:>9} {:>9}  {:<15} at 64, times uniform's\n", "", "", "error", "", "", "");
    fmt::print("{:<12} {:<11} {:>9} {:>9} {:>9}  {:<15} {:>8} {:>8} {:>8}\n", "integrand", "strategy", "at 16", "at 64",
        "at 4096", "slope", "samples", "time", "error");
}

void print(const ErrorCurve& curve)
{
    fmt::print("{:<12} {:<11} {:>9.2e} {:>9.2e} {:>9.2e}  {:>5.2f} +- {:<6.2f} {:>8} {:>8} {:>8}\n", curve.integrand,
        curve.strategy, errorAt(16, curve), errorAt(64, curve), errorAt(4096, curve), curve.slope.value,
        curve.slope.halfInterval, fmt::format("1/{:.1f}", curve.at64.samples),
        fmt::format("1/{:.1f}", curve.at64.seconds), fmt::format("1/{:.1f}", curve.at64.error));
}

void printTimes(const std::vector<ErrorCurve>& curves)
{
    fmt::print("\nmicroseconds to reach an error of\n{:<12} {:<11}", "integrand", "strategy");
    for (const double error : errorsToReach)
        fmt::print(" {:>8}", error);
    fmt::print("\n");
    for (const ErrorCurve& curve : curves) {
        fmt::print("{:<12} {:<11}", curve.integrand, curve.strategy);
        for (const double error : errorsToReach) {
            const std::optional<double> seconds = secondsToReach(error, curve.points);
            fmt::print(" {:>8}", seconds ? fmt::format("{:.1f}", 1e6 * *seconds) : "-");
        }
        fmt::print("\n");
    }
}

nlohmann::json toJson(const std::vector<ErrorCurve>& curves)
{
    nlohmann::json report;
    for (const ErrorCurve& curve : curves) {
        nlohmann::json& part = curve.strategy == "pairs" ? report["pairs"] : report;
        const auto set = [&](const char* name, const nlohmann::json& value) {
            part[name][curve.integrand][curve.strategy] = value;
        };
        set("slope", curve.slope.value);
        set("slope_half_interval", curve.slope.halfInterval);
        set("gain_at_64", curve.at64.samples);
        set("time_gain_at_64", curve.at64.seconds);
        set("error_ratio_at_equal_time", curve.at64.error);
        set("seconds_to_reach", timesOf(curve));
        set("points", toJson(curve.points));
    }
    return report;
}

}
