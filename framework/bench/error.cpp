#include "bench/error.h"
#include "app/renderer.h"
#include "app/run_command.h"
#include "bench/error_report.h"
#include "files/text.h"
#include <nlohmann/json.hpp>

namespace bench {
namespace {

    using worker::Integrand;
    using worker::Strategy;

    struct Options {
        std::string with = "reference";
        std::string json, plots;
        uint32_t numEstimates = 2048;
    };

    struct Experiment {
        const char *integrandName, *strategyName;
        Integrand integrand;
        Strategy strategy;
        double slope; // of the error by number of samples
    };

    // What the slopes should be: of edges, by the cells that they cross (Mitchell 1996, "Consequences of Stratified
    // Sampling in Graphics"); of the smooth one, by Owen 1997, "Scrambled Net Variance for Integrals of Smooth
    // Functions"; of pairs, by what of the integrand is no sum of functions of x and of y (Stein 1987, "Large Sample
    // Properties of Simulations Using Latin Hypercube Sampling").
    constexpr Experiment experiments[] = {
        { "edge", "uniform", Integrand::Edge, Strategy::Uniform, -0.5 },
        { "edge", "stratified", Integrand::Edge, Strategy::Stratified, -0.75 },
        { "edge", "owen", Integrand::Edge, Strategy::Owen, -0.75 },
        { "axis_edge", "uniform", Integrand::AxisEdge, Strategy::Uniform, -0.5 },
        { "axis_edge", "stratified", Integrand::AxisEdge, Strategy::Stratified, -0.75 },
        { "axis_edge", "owen", Integrand::AxisEdge, Strategy::Owen, -1.0 },
        { "soft_shadow", "uniform", Integrand::SoftShadow, Strategy::Uniform, -0.5 },
        { "soft_shadow", "stratified", Integrand::SoftShadow, Strategy::Stratified, -0.75 },
        { "soft_shadow", "owen", Integrand::SoftShadow, Strategy::Owen, -0.75 },
        { "soft_shadow", "pairs", Integrand::SoftShadow, Strategy::Pairs, -0.5 },
        { "smooth", "uniform", Integrand::Smooth, Strategy::Uniform, -0.5 },
        { "smooth", "stratified", Integrand::Smooth, Strategy::Stratified, -1.0 },
        { "smooth", "owen", Integrand::Smooth, Strategy::Owen, -1.5 },
        { "smooth", "pairs", Integrand::Smooth, Strategy::Pairs, -0.5 },
    };

    constexpr uint32_t numbersOfSamples[] = { 1, 4, 16, 64, 256, 1024, 4096 }; // squares, and powers of two

    // More where they take little time: what is compared at 64 samples wants an error within a percent.
    uint32_t numEstimates(uint32_t numSamples, const Options& options)
    {
        return options.numEstimates * std::clamp(4096 / numSamples, 1u, 16u);
    }

    // Of all that is measured, by samples. Who asks a worker clears the bar, which is drawn again.
    class Progress {
    public:
        explicit Progress(double whole)
            : m_whole(whole)
        {
        }

        void add(double part)
        {
            m_done += part;
            app::drawProgressBar(static_cast<float>(m_done / m_whole));
        }

    private:
        double m_whole, m_done = 0.0;
    };

    double numSamplesOfCurve(const Options& options)
    {
        double sum = 0.0;
        for (const uint32_t numSamples : numbersOfSamples)
            sum += static_cast<double>(numSamples) * numEstimates(numSamples, options);
        return sum;
    }

    ErrorPoint measure(
        app::Renderer& renderer, const Experiment& experiment, uint32_t numSamples, const Options& options)
    {
        const worker::EstimateRequest request { experiment.integrand, experiment.strategy, numSamples,
            numEstimates(numSamples, options), numSamples * 0x01000193u };
        return errorOf(
            renderer.ask<worker::Estimates>("sampling.estimates", request), truthsOf(experiment.integrand), numSamples);
    }

    ErrorCurve measureCurve(
        app::Renderer& renderer, const Experiment& experiment, const Options& options, Progress& progress)
    {
        ErrorCurve curve {
            .integrand = experiment.integrandName, .strategy = experiment.strategyName, .theory = experiment.slope
        };
        for (const uint32_t numSamples : numbersOfSamples) {
            curve.points.push_back(measure(renderer, experiment, numSamples, options));
            progress.add(static_cast<double>(numSamples) * numEstimates(numSamples, options));
        }
        curve.slope = fitSlope({ std::ranges::find(curve.points, 16u, &ErrorPoint::numSamples), curve.points.end() });
        return curve;
    }

    std::vector<ErrorCurve> measureAll(const Options& options)
    {
        app::Renderer renderer(options.with);
        Progress progress(std::size(experiments) * numSamplesOfCurve(options));
        std::vector<ErrorCurve> curves;
        ErrorPoint uniformAt64 {}; // of the same integrand
        printErrorHeader();
        for (const Experiment& experiment : experiments) {
            ErrorCurve curve = measureCurve(renderer, experiment, options, progress);
            const ErrorPoint& at64 = *std::ranges::find(curve.points, 64u, &ErrorPoint::numSamples);
            if (experiment.strategy == Strategy::Uniform)
                uniformAt64 = at64;
            curve.at64 = gainOver(uniformAt64, at64);
            app::clearProgressBar();
            print(curve);
            curves.push_back(std::move(curve));
        }
        return curves;
    }

    int run(const Options& options)
    {
        try {
            const std::vector<ErrorCurve> curves = measureAll(options);
            printTimes(curves);
            if (!options.json.empty())
                files::writeText(options.json, toJson(curves).dump(2) + "\n");
            if (!options.plots.empty())
                plot(curves, options.plots);
            return app::Success;
        } catch (const worker::Failure& failure) {
            fmt::print(stderr, "the code of {} failed: {}\n", options.with, failure.what());
            return app::SubmissionFailed;
        }
    }

}

Command declareError(CLI::App& cli)
{
    const auto options = std::make_shared<Options>();
    CLI::App& command = *cli.add_subcommand("error", "Run time against error of sampling, where the truth is known");
    command.add_option("--with", options->with, "Whose code: student, reference, or a submission's folder")
        ->capture_default_str();
    command
        .add_option("--estimates", options->numEstimates, "Estimates of 4,096 samples; of fewer up to 16 times more")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    command.add_option("--json", options->json, "Write the figures to this file");
    command.add_option("--plots", options->plots, "Draw them into this folder, as SVG and PNG, by gnuplot");
    command.footer(
        "edge, axis_edge: a pixel across which an edge lies, at any angle or along the pixel's sides. soft_shadow, "
        "smooth: a parallelogram light, blocked in part or not at all. pairs: the light's points of two numbers that "
        "are even each alone; of uniform ones they are the same as points.\n"
        "Exit codes: 0 done, 2 bad input, 70 the submission's code failed.");
    return { &command, [options] { return run(*options); } };
}

}
