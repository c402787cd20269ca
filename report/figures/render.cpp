// Where the 25 rays of a pixel go through it, uniform and stratified; after figure 8.24 of Pharr, Jakob and Humphreys,
// "Physically Based Rendering", 4th edition.
#include "report/figure.h"
#include "report/plot.h"
#include "report/probes/pixel_question.h"
#include "report/statistics.h"
#include "report/studio.h"
#include <fmt/format.h>

namespace report::render {
namespace {

    constexpr int cells = 5; // along each side of a pixel
    constexpr PixelQuestion uniform { { 20, 20 }, cells* cells, false, 1 };
    constexpr PixelQuestion stratified { { 20, 20 }, cells* cells, true, 1 };

    // Relative to each pixel.
    PixelSamples samplesOf(Studio& studio, Who who, const PixelQuestion& question)
    {
        PixelSamples samples = studio.ask<PixelSamples>(who, "figures.pixel_samples", question);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const int x = static_cast<int>(i) % question.size.x, y = static_cast<int>(i) / question.size.x;
            for (glm::vec2& place : samples[i])
                place -= glm::vec2(x, y);
        }
        return samples;
    }

    // Of all pixels: how many rays are in each cell.
    std::vector<int> countsOf(const PixelSamples& samples)
    {
        std::vector<int> counts;
        for (const std::vector<glm::vec2>& inPixel : samples)
            std::ranges::copy(countCells(inPixel, cells), std::back_inserter(counts));
        return counts;
    }

    std::vector<std::vector<double>> toRows(const std::vector<glm::vec2>& places)
    {
        std::vector<std::vector<double>> rows;
        for (const glm::vec2& place : places)
            rows.push_back({ place.x, place.y });
        return rows;
    }

    Plot plotOf(const std::string& label, const std::string& name, const std::vector<glm::vec2>& own,
        const std::vector<glm::vec2>& reference)
    {
        return { label,
            dataBlock("own", toRows(own)) + dataBlock("reference", toRows(reference))
                + fmt::format(R"gp(
set size square; set border 15; set xrange [0:1]; set yrange [0:1]; set xtics 0.2; set ytics 0.2
set grid xtics ytics linecolor rgb "#7f8a99" linewidth 1.2 dashtype solid
set key outside top center horizontal
plot $reference using 1:2 with points linetype 7 pointtype 6 pointsize 1.5 title "reference", \
     $own using 1:2 with points linetype 1 title {}, {}
)gp",
                    quoted(name), hoverPoints("own", 1)),
            { 480, 500 } };
    }

    std::vector<int> countsInFirst(const PixelSamples& samples)
    {
        return countCells(samples.front(), cells);
    }

    Sheet drawGrid(Studio& studio)
    {
        const PixelSamples ownUniform = samplesOf(studio, Who::Submission, uniform);
        const PixelSamples ownStratified = samplesOf(studio, Who::Submission, stratified);
        const PixelSamples uniformReference = samplesOf(studio, Who::Reference, uniform);
        const PixelSamples stratifiedReference = samplesOf(studio, Who::Reference, stratified);
        const std::vector<int> inUniform = countsOf(ownUniform), inStratified = countsOf(ownStratified);
        const double clumps = dispersion(inUniform), even = dispersion(inStratified);
        const auto numEmpty = std::ranges::count(countsInFirst(ownUniform), 0);
        const std::string name = studio.nameOf(Who::Submission);
        Sheet sheet;
        sheet.panels = { plotOf("25 uniform rays", name, ownUniform.front(), uniformReference.front()),
            plotOf("25 stratified rays, one in each cell", name, ownStratified.front(), stratifiedReference.front()) };
        sheet.facts = { { "shown", "the pixel at the bottom left of 20 × 20" }, { "samples", "25" }, { "seed", "1" } };
        sheet.claims = {
            { fmt::format(
                  "Uniform rays clump: {} of the 25 cells of the pixel shown are empty, and over all 400 pixels "
                  "the counts of cells have variance / mean {:.2f}; independent places give 24/25 = 0.96.",
                  numEmpty, clumps),
                std::abs(clumps - 0.96) < 0.06 }, // 10,000 counts tell it to 0.014
            { fmt::format("Stratified rays do not: variance / mean is {:.2g}, as each cell has one.", even),
                even == 0.0 && ownStratified.front().size() == std::size_t(cells * cells) },
        };
        sheet.data = { { "uniform", toRows(ownUniform.front()) }, { "stratified", toRows(ownStratified.front()) },
            { "counts", countsInFirst(ownStratified) }, { "dispersion", { clumps, even } } };
        return sheet;
    }

    const Figure grid("multisampling.grid", "Where 25 rays go through a pixel", Part::VisualDebugging, drawGrid);

}
}
