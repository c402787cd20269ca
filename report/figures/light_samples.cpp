// Samples of a parallelogram light, by two numbers of the sampler and by a pair of them.
#include "report/figure.h"
#include "report/plot.h"
#include "report/probes/light_question.h"
#include "report/statistics.h"
#include "report/studio.h"
#include <fmt/format.h>

namespace report::light_samples {
namespace {

    // The unit square, so that a position is where it is along both edges. Its colours can be told apart on any ground.
    const ParallelogramLight unitSquare { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.0f, 0.45f, 0.7f },
        { 0.84f, 0.37f, 0.0f }, { 0.0f, 0.62f, 0.45f }, { 0.8f, 0.47f, 0.65f } };
    const LightSamplesQuestion question { unitSquare, 2000, 1, 2 };

    std::vector<glm::vec2> placesOf(const std::vector<LightSample>& samples)
    {
        std::vector<glm::vec2> places;
        for (const LightSample& sample : samples)
            places.emplace_back(sample.position);
        return places;
    }

    // Places and colours, for gnuplot.
    std::vector<std::vector<double>> toRows(const std::vector<LightSample>& samples)
    {
        std::vector<std::vector<double>> rows;
        for (const LightSample& s : samples) {
            const glm::ivec3 color = glm::ivec3(glm::clamp(s.color, 0.0f, 1.0f) * 255.0f + 0.5f);
            rows.push_back(
                { s.position.x, s.position.y, static_cast<double>((color.r * 256 + color.g) * 256 + color.b) });
        }
        return rows;
    }

    // How many lie in each twentieth of the first edge, or of the second.
    std::vector<std::vector<double>> histogram(const std::vector<LightSample>& samples, int edge)
    {
        constexpr int bins = 20;
        std::vector<std::vector<double>> rows;
        for (int i = 0; i < bins; ++i)
            rows.push_back({ (i + 0.5) / bins, 0.0 });
        for (const LightSample& sample : samples)
            ++rows[static_cast<std::size_t>(glm::clamp(static_cast<int>(sample.position[edge] * bins), 0, bins - 1))]
                  [1];
        return rows;
    }

    // The samples, and above and beside them how they are distributed along the two edges.
    Plot scatter(const std::string& label, const std::vector<LightSample>& samples)
    {
        return { label,
            dataBlock("samples", toRows(samples)) + dataBlock("first", histogram(samples, 0))
                + dataBlock("second", histogram(samples, 1)) + R"gp(
mean = 100
set multiplot
set lmargin at screen 0.15; set rmargin at screen 0.78; set bmargin at screen 0.12; set tmargin at screen 0.77
set xrange [0:1]; set yrange [0:1]; set xtics 0.25; set ytics 0.25
set xlabel "along the first edge"; set ylabel "along the second edge" offset 1
plot $samples using 1:2:3 with points pointtype 7 pointsize 0.28 linecolor rgb variable notitle
unset xlabel; unset ylabel; set style fill solid 0.75 noborder; set boxwidth 0.042
set bmargin at screen 0.79; set tmargin at screen 0.97
set yrange [0:150]; set ytics (mean); set format x ""
plot $first using 1:2 with boxes linetype 7 notitle, mean with lines linetype 1 linewidth 1 notitle, \
     $first using 1:2:(sprintf("%g samples", $2)) with labels hypertext point linetype 9 notitle
set lmargin at screen 0.8; set rmargin at screen 0.98; set bmargin at screen 0.12; set tmargin at screen 0.77
set xrange [0:150]; set yrange [0:1]; set xtics (mean); set format x "%g"; set ytics 0.25; set format y ""
set arrow from mean, 0 to mean, 1 nohead linetype 1 linewidth 1 front
plot $second using ($2 / 2):1:($2 / 2):(0.021) with boxxyerror linetype 7 notitle, \
     $second using 2:1:(sprintf("%g samples", $2)) with labels hypertext point linetype 9 notitle
unset multiplot
)gp",
            { 520, 520 } };
    }

    double largestGap(const std::vector<LightSample>& a, const std::vector<LightSample>& b)
    {
        float largest = 0.0f;
        for (std::size_t i = 0; i < a.size(); ++i)
            largest = std::max(
                { largest, glm::distance(a[i].position, b[i].position), glm::distance(a[i].color, b[i].color) });
        return largest;
    }

    Sheet drawSamples(Studio& studio)
    {
        const auto own = studio.ask<LightSamples>(Who::Submission, "figures.light_samples", question);
        const auto reference = studio.ask<LightSamples>(Who::Reference, "figures.light_samples", question);
        constexpr int cells = 8;
        const std::vector<glm::vec2> twice = placesOf(own.twice1d), once = placesOf(own.once2d);
        const double p = pValueOfDifference(twice, once, cells);
        const double gap
            = std::max(largestGap(own.twice1d, reference.twice1d), largestGap(own.once2d, reference.once2d));
        Sheet sheet;
        sheet.panels = { scatter("The 1D sampler, twice", own.twice1d), scatter("The 2D sampler", own.once2d) };
        sheet.facts = { { "light", "the unit square, a colour at each corner" },
            { "samples", fmt::format("{} each", question.number) },
            { "seeds", fmt::format("{} and {}", question.seedTwice1d, question.seed2d) },
            { "counts in 8 × 8 cells",
                fmt::format("dispersion {:.2f} and {:.2f}, of independent samples about 1",
                    dispersion(countCells(twice, cells)), dispersion(countCells(once, cells))) },
            { "largest difference to the reference", fmt::format("{:.2g}", gap) } };
        sheet.claims = { { fmt::format("The two are distributed alike: their counts in 8 × 8 cells differ as much as "
                                       "those of one distribution do (chi-square, p = {:.2f}).",
                               p),
            p > 0.01 } };
        sheet.data = { { "p", p }, { "gap", gap }, { "number", { twice.size(), once.size() } } };
        return sheet;
    }

    const Figure samples("light.samples", "Samples of a light: the 1D sampler twice, and the 2D sampler",
        Part::VisualDebugging, drawSamples);

}
}
