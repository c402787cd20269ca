#include "bench/error.h"
#include "app/renderer.h"
#include "app/run_command.h"
#include "bench/error_curve.h"
#include "files/text.h"
#include <nlohmann/json.hpp>

namespace bench {
namespace {

    struct Options {
        std::string with = "reference";
        std::string json;
        uint32_t numEstimates = 4000;
    };

    struct Named {
        const char* name;
        uint32_t value;
    };
    constexpr Named integrands[] = { { "edge", uint32_t(worker::Integrand::Edge) },
        { "axis_edge", uint32_t(worker::Integrand::AxisEdge) },
        { "soft_shadow", uint32_t(worker::Integrand::SoftShadow) }, { "smooth", uint32_t(worker::Integrand::Smooth) } };
    constexpr Named strategies[] = { { "uniform", uint32_t(worker::Strategy::Uniform) },
        { "stratified", uint32_t(worker::Strategy::Stratified) }, { "owen", uint32_t(worker::Strategy::Owen) } };

    std::vector<ErrorPoint> measureCurve(
        app::Renderer& renderer, const Named& integrand, const Named& strategy, const Options& options)
    {
        const auto which = static_cast<worker::Integrand>(integrand.value);
        const std::vector<double> truths = truthsOf(which);
        std::vector<ErrorPoint> points;
        for (uint32_t numSamples = 1; numSamples <= 4096; numSamples *= 4) { // squares, and powers of two
            const worker::EstimateRequest request { which, static_cast<worker::Strategy>(strategy.value), numSamples,
                options.numEstimates, 1 + numSamples * options.numEstimates };
            points.push_back(
                errorOf(renderer.ask<worker::Estimates>("sampling.estimates", request), truths, numSamples));
        }
        return points;
    }

    nlohmann::json toJson(const std::vector<ErrorPoint>& points)
    {
        nlohmann::json rows = nlohmann::json::array();
        for (const ErrorPoint& p : points)
            rows.push_back(
                { { "samples", p.numSamples }, { "error", p.error }, { "mean", p.mean }, { "seconds", p.seconds } });
        return rows;
    }

    // One sample is no pattern yet.
    std::vector<ErrorPoint> ofMany(const std::vector<ErrorPoint>& points)
    {
        std::vector<ErrorPoint> many;
        std::ranges::copy_if(points, std::back_inserter(many), [](const ErrorPoint& p) { return p.numSamples >= 16; });
        return many;
    }

    const ErrorPoint& at64(const std::vector<ErrorPoint>& points)
    {
        return *std::ranges::find(points, 64u, &ErrorPoint::numSamples);
    }

    int measure(const Options& options)
    {
        app::Renderer renderer(options.with);
        nlohmann::json report;
        fmt::print("{:<12} {:<11} {:>9} {:>9} {:>9}  {:<16} gain at 64\n", "integrand", "strategy", "at 16", "at 64",
            "at 4096", "slope");
        for (const Named& integrand : integrands) {
            double uniformAt64 = 0.0;
            for (const Named& strategy : strategies) {
                const std::vector<ErrorPoint> points = measureCurve(renderer, integrand, strategy, options);
                const Slope slope = fitSlope(ofMany(points));
                const double error = at64(points).error;
                if (uniformAt64 == 0.0)
                    uniformAt64 = error;
                const double gain = uniformAt64 * uniformAt64 / (error * error); // uniform's error falls as its root
                fmt::print("{:<12} {:<11} {:>9.2e} {:>9.2e} {:>9.2e}  {:>5.2f} +- {:<7.2f} {:>5.1f}\n", integrand.name,
                    strategy.name, points[2].error, error, points.back().error, slope.value, slope.halfInterval, gain);
                report["slope"][integrand.name][strategy.name] = slope.value;
                report["slope_half_interval"][integrand.name][strategy.name] = slope.halfInterval;
                report["gain_at_64"][integrand.name][strategy.name] = gain;
                report["points"][integrand.name][strategy.name] = toJson(points);
            }
        }
        if (!options.json.empty())
            files::writeText(options.json, report.dump(2) + "\n");
        return app::Success;
    }

    int run(const Options& options)
    {
        try {
            return measure(options);
        } catch (const worker::Failure& failure) {
            fmt::print(stderr, "the code of {} failed: {}\n", options.with, failure.what());
            return app::SubmissionFailed;
        }
    }

}

Command declareError(CLI::App& cli)
{
    const auto options = std::make_shared<Options>();
    CLI::App& command = *cli.add_subcommand("error", "Samples against error, where the truth is known");
    command.add_option("--with", options->with, "Whose code: student, reference, or a submission's folder")
        ->capture_default_str();
    command.add_option("--estimates", options->numEstimates, "Estimates of each kind")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    command.add_option("--json", options->json, "Write the figures to this file");
    command.footer("Exit codes: 0 done, 2 bad input, 70 the submission's code failed.");
    return { &command, [options] { return run(*options); } };
}

}
