// What the number of samples of an area light does to a soft shadow.
#include "bench/error_curve.h"
#include "report/figure.h"
#include "report/pictures.h"
#include "report/plot.h"
#include "report/studio.h"
#include <fmt/format.h>

namespace report::light_noise {
namespace {

    // Against what clipping and quadrature give for points in a half-shadow.
    std::vector<bench::ErrorPoint> errorCurve(Studio& studio, Who who)
    {
        const std::vector<double> truths = bench::truthsOf(worker::Integrand::SoftShadow);
        std::vector<bench::ErrorPoint> curve;
        for (uint32_t numSamples = 1; numSamples <= 256; numSamples *= 4) {
            constexpr uint32_t number = 2000;
            const worker::EstimateRequest request { worker::Integrand::SoftShadow, worker::Strategy::Uniform,
                numSamples, number, 1 + numSamples * number };
            curve.push_back(
                bench::errorOf(studio.ask<worker::Estimates>(who, "sampling.estimates", request), truths, numSamples));
        }
        return curve;
    }

    std::vector<std::vector<double>> toRows(const std::vector<bench::ErrorPoint>& curve)
    {
        std::vector<std::vector<double>> rows;
        for (const bench::ErrorPoint& point : curve)
            rows.push_back({ static_cast<double>(point.numSamples), point.error });
        return rows;
    }

    Plot plotOf(Studio& studio, const std::vector<bench::ErrorPoint>& own, const std::vector<bench::ErrorPoint>& other)
    {
        return { "RMSE of a point in a half-shadow against the number of samples, and the line with slope -1/2",
            dataBlock("own", toRows(own)) + dataBlock("other", toRows(other))
                + fmt::format(R"gp(set logscale xy; set xlabel "samples of the light"; set ylabel "RMSE"
set xrange [0.8:320]; set format y "%g"
plot {:.4g} / sqrt(x) with lines linetype 7 dashtype 2 title "slope -1/2", \
     $other using 1:2 with lines linetype 2 title "reference", \
     $own using 1:2 with points linetype 1 title {}, {}
)gp",
                    other.front().error, quoted(studio.nameOf(Who::Submission)), hoverPoints("own", 1)),
            { 520, 300 } };
    }

    Sheet drawNoise(Studio& studio)
    {
        const glm::ivec2 size { 120, 90 }, from { 8, 20 }, part { 60, 45 };
        const auto render = [&](Who who, int numSamples) {
            const worker::RenderRequest request
                = sceneNamed("light_parallelogram", size, { fmt::format("shadow_samples={}", numSamples) });
            return toPicture(
                fmt::format("{} sample{}", numSamples, numSamples == 1 ? "" : "s"), studio.render(who, request));
        };
        const Picture truth = render(Who::Reference, 1024);
        Sheet sheet;
        std::vector<double> errors;
        for (const int numSamples : { 1, 4, 16, 64 }) {
            const Picture picture = render(Who::Submission, numSamples);
            errors.push_back(rmse(truth, picture));
            Picture& shown = std::get<Picture>(sheet.panels.emplace_back(magnified(crop(picture, from, part), 9)));
            shown.label += fmt::format(": RMSE {:.3f}", errors.back());
        }
        const auto own = errorCurve(studio, Who::Submission);
        const bench::Slope slope = bench::fitSlope(own);
        sheet.panels.emplace_back(plotOf(studio, own, errorCurve(studio, Who::Reference)));
        sheet.facts = { { "scene", "light_parallelogram.toml" }, { "samples", "1 a pixel, 1 to 64 a light" },
            { "truth of the pictures", "the reference's, 1024 samples" },
            { "truth of the plot", "clipping and quadrature" }, { "estimates", "2000 a point" }, { "seed", "0" } };
        sheet.claims = { { fmt::format("Four times as many samples halve the noise: its slope is {:.2f} ± {:.2f} on "
                                       "logarithmic axes, of independent samples -0.5.",
                               slope.value, slope.halfInterval),
            std::abs(slope.value + 0.5) < 0.05 } }; // 2000 estimates tell an error to 1.6 %, a slope to about 0.01
        sheet.data = { { "errors", errors }, { "slope", slope.value } };
        return sheet;
    }

    const Figure noise("light.noise", "Samples of a light, and noise", Part::RenderedImages, drawNoise);

}
}
