// What the linear gradient model looks like.
#include "report/figure.h"
#include "report/figures/shading_questions.h"
#include "report/pictures.h"
#include "report/plot.h"
#include <fmt/format.h>

namespace report::shading {
namespace {

    // Of light from 180 degrees to 0 off the normal.
    std::vector<glm::vec3> colorsOfCosines(Studio& studio, Who who, const std::vector<double>& cosines)
    {
        std::vector<ShadingQuestion> questions;
        for (const double cosine : cosines)
            questions.push_back({ .toLight = direction(glm::degrees(std::acos(cosine))) });
        return shade(studio, who, questions);
    }

    Sheet drawBar(Studio& studio)
    {
        const std::vector<double> cosines = evenly(-1.0, 1.0, 201);
        const std::vector<glm::vec3> colors = colorsOfCosines(studio, Who::Submission, cosines);
        const std::vector<glm::vec3> expected = colorsOfCosines(studio, Who::Reference, cosines);
        std::vector<std::vector<double>> rows;
        float largest = 0.0f;
        for (std::size_t i = 0; i < cosines.size(); ++i) {
            const glm::vec3 c = glm::clamp(colors[i], 0.0f, 1.0f);
            rows.push_back({ cosines[i], c.r, c.g, c.b });
            for (int channel = 0; channel < 3; ++channel)
                largest = std::max(largest, std::abs(colors[i][channel] - expected[i][channel]));
        }
        Sheet sheet;
        sheet.columns = 1;
        sheet.panels = { Plot { "The gradient, and its red, green and blue at the cosine of the angle to the light",
            dataBlock("gradient", rows) + R"plot(
set xrange [-1:1]; set yrange [-0.32:1.04]; set xlabel "n · l"; set ylabel "colour" offset 1; set ytics 0, 0.25
set key at graph 0.02, 0.97 left top horizontal; set grid xtics ytics; set xtics 0.25
rgb(r, g, b) = int(255 * r + 0.5) * 65536 + int(255 * g + 0.5) * 256 + int(255 * b + 0.5)
plot $gradient using 1:(-0.3):(0.0052):(0.11):(rgb($2, $3, $4)) \
         with boxxyerror fill solid linecolor rgb variable notitle, \
     $gradient using 1:2 with lines linecolor rgb "#d55e00" linewidth 2 title "red", \
     $gradient using 1:3 with lines linecolor rgb "#009e73" linewidth 2 title "green", \
     $gradient using 1:4 with lines linecolor rgb "#0072b2" linewidth 2 title "blue", \
     for [channel = 2:4] $gradient using 1:channel:(sprintf("n·l %.2f: (%.2f, %.2f, %.2f)", $1, $2, $3, $4)) \
         every 10 with labels hypertext point pointtype 7 pointsize 0.3 linecolor rgb "#626b78" notitle
)plot",
            { 720, 300 } } };
        sheet.facts = { { "samples", "201 angles" }, { "random numbers", "none" } };
        sheet.data = { { "rows", rows } };
        sheet.claims = { { fmt::format("The largest difference to the reference, over 201 angles and all channels, is "
                                       "{:.2g}.",
                               largest),
            largest <= 1e-4f } }; // rounding of cosines, times slopes of at most 3
        return sheet;
    }

    const Figure gradient(
        "shading.gradient", "The linear gradient on a sphere and a cube", Part::RenderedImages, [](Studio& studio) {
            return againstReference(studio, sceneNamed("gradient", { 1060, 530 }));
        });
    const Figure colorBar("shading.color_bar", "The gradient, sampled", Part::VisualDebugging, drawBar);

}
}
