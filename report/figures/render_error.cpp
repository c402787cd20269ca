// What sampling a pixel errs against the truth, by number of rays and by time.
#include "bench/error_curve.h"
#include "report/figure.h"
#include "report/plot.h"
#include "report/studio.h"
#include <fmt/format.h>

namespace report::render_error {
namespace {

    using Curve = std::vector<bench::ErrorPoint>;

    Curve measure(Studio& studio, worker::Strategy strategy)
    {
        const std::vector<double> truths = bench::truthsOf(worker::Integrand::Edge);
        Curve curve;
        for (uint32_t numSamples = 1; numSamples <= 1024; numSamples *= 4) { // squares
            constexpr uint32_t number = 2000;
            const worker::EstimateRequest request { worker::Integrand::Edge, strategy, numSamples, number,
                1 + numSamples * number };
            const auto estimates = studio.ask<worker::Estimates>(Who::Submission, "sampling.estimates", request);
            curve.push_back(bench::errorOf(estimates, truths, numSamples));
        }
        return curve;
    }

    // One ray is no pattern yet.
    bench::Slope slopeOf(Curve curve)
    {
        std::erase_if(curve, [](const bench::ErrorPoint& point) { return point.numSamples < 4; });
        return bench::fitSlope(curve);
    }

    std::vector<std::vector<double>> bySamples(const Curve& curve)
    {
        std::vector<std::vector<double>> rows;
        for (const bench::ErrorPoint& point : curve)
            rows.push_back({ static_cast<double>(point.numSamples), point.error });
        return rows;
    }

    std::vector<std::vector<double>> byTime(const Curve& curve)
    {
        std::vector<std::vector<double>> rows;
        for (const bench::ErrorPoint& point : curve)
            rows.push_back({ 1e6 * point.seconds, point.error });
        return rows;
    }

    Plot plotOf(const std::string& label, const std::string& abscissa, const std::vector<std::vector<double>>& uniform,
        const std::vector<std::vector<double>>& stratified, const bench::Slope& ofUniform,
        const bench::Slope& ofStratified)
    {
        return { label,
            dataBlock("uniform", uniform) + dataBlock("stratified", stratified)
                + fmt::format(R"gp(
set logscale xy; set xlabel "{}"; set ylabel "RMSE"; set key bottom left
set format x "10^{{%L}}"; set format y "10^{{%L}}"
plot $uniform using 1:2 with linespoints linetype 1 title "uniform, slope {:.2f}", \
     $stratified using 1:2 with linespoints linetype 2 title "stratified, slope {:.2f}", {}, {}
)gp",
                    abscissa, ofUniform.value, ofStratified.value, hoverPoints("uniform", 1),
                    hoverPoints("stratified", 2)),
            { 520, 400 } };
    }

    Sheet drawError(Studio& studio)
    {
        (void)measure(studio, worker::Strategy::Uniform); // the first time takes longer
        const Curve uniform = measure(studio, worker::Strategy::Uniform);
        const Curve stratified = measure(studio, worker::Strategy::Stratified);
        const bench::Slope ofUniform = slopeOf(uniform), ofStratified = slopeOf(stratified);
        Sheet sheet;
        sheet.panels = { plotOf("Error against rays a pixel", "rays a pixel", bySamples(uniform), bySamples(stratified),
                             ofUniform, ofStratified),
            plotOf("Error against time", "microseconds a pixel", byTime(uniform), byTime(stratified), ofUniform,
                ofStratified) };
        sheet.facts = { { "scene", "pixels that a slanting edge crosses; the truth is its area, by clipping" },
            { "samples", "1 to 1024" }, { "estimates", "2000 a point" }, { "seeds", "1 and up" } };
        const auto gain = [&](std::size_t i) { return uniform[i].error / stratified[i].error; };
        sheet.claims = {
            { fmt::format("Uniform rays: slope {:.2f} ± {:.2f}; independent samples have -0.5.", ofUniform.value,
                  ofUniform.halfInterval),
                std::abs(ofUniform.value + 0.5) < 0.05 }, // 2000 estimates tell a slope to about 0.01
            { fmt::format(
                  "Stratified rays: slope {:.2f} ± {:.2f}; only the cells that the edge crosses are uncertain, and "
                  "of n × n these are about n: -0.75. So 16 of them err {:.1f} times less than uniform ones, 1024 "
                  "{:.1f} times.",
                  ofStratified.value, ofStratified.halfInterval, gain(2), gain(5)),
                std::abs(ofStratified.value + 0.75) < 0.05 },
        };
        sheet.data = { { "uniform", bySamples(uniform) }, { "stratified", bySamples(stratified) },
            { "slopes", { ofUniform.value, ofStratified.value } } };
        return sheet;
    }

    const Figure error("multisampling.error", "Error against rays, and against time", Part::VisualDebugging, drawError);

}
}
