// What the comparison of Phong and Blinn-Phong shows, and why.
#include "report/figure.h"
#include "report/figures/shading_questions.h"
#include "report/pictures.h"
#include "report/plot.h"
#include <fmt/format.h>

namespace report::shading_lobes {
namespace {

    // Where each is brighter, and where they are equal.
    struct Legend {
        glm::vec3 phong, equal, blinnPhong;
    };

    // As the submission answers: which half of the gradient is whose is up to it. In front of a surface no Phong lobe
    // is brighter than Blinn's of the same shininess; seen from below, in grazing light, it is.
    Legend legendOf(Studio& studio, Who who)
    {
        constexpr auto comparison = ShadingModel::LinearGradientComparison;
        const std::vector<glm::vec3> colors = shade(studio, who,
            { { comparison, direction(80.0), direction(-110.0), 1.0f },
                { comparison, direction(0.0), direction(0.0), 1.0f },
                { comparison, direction(40.0), direction(-75.0), 10.0f } });
        return { colors[0], colors[1], colors[2] };
    }

    std::string swatch(int index, const glm::vec3& color, const std::string& meaning)
    {
        const glm::vec3 c = glm::clamp(color, 0.0f, 1.0f) * 255.0f + 0.5f;
        return fmt::format(
            "set object {0} rectangle from {1},0 to {2},1 fillcolor rgb \"#{3:02x}{4:02x}{5:02x}\" fillstyle "
            "solid border linecolor rgb \"#98a4b5\"\nset label {0} \"{6}\" at {7},0.5\n",
            index, 10 * index, 10 * index + 1, int(c.r), int(c.g), int(c.b), meaning, 10.0 * index + 1.4);
    }

    // As the picture shows the colours: in the scene's light.
    Plot drawLegend(const Legend& legend, float light)
    {
        return { "",
            swatch(1, light * legend.phong, "Phong contributes more")
                + swatch(2, light * legend.equal, "equal, or no light")
                + swatch(3, light * legend.blinnPhong, "Blinn-Phong contributes more") + R"plot(
unset border; unset tics; unset key; unset grid; set margins 0, 0, 0, 0; set xrange [9.9:40]; set yrange [-0.1:1.1]
plot NaN
)plot",
            { 720, 24 } };
    }

    double distance(const glm::vec3& a, const glm::vec3& b)
    {
        return glm::length(glm::dvec3(a) - glm::dvec3(b));
    }

    // Of the picture, by the legend's nearest colour; pixels without a surface are black and do not count.
    struct Shares {
        double phong = 0.0, equal = 0.0, blinnPhong = 0.0;
    };

    Shares sharesOf(const Picture& picture, const Legend& legend, float lightColor)
    {
        Shares shares;
        double number = 0.0;
        for (const glm::vec3& pixel : picture.pixels) {
            if (pixel == glm::vec3(0.0f))
                continue;
            const glm::vec3 color = pixel / lightColor;
            constexpr double justNoticeable = 0.02;
            ++number;
            if (distance(color, legend.equal) < justNoticeable)
                ++shares.equal;
            else
                ++(distance(color, legend.phong) < distance(color, legend.blinnPhong) ? shares.phong
                                                                                      : shares.blinnPhong);
        }
        return { shares.phong / number, shares.equal / number, shares.blinnPhong / number };
    }

    Sheet drawComparison(Studio& studio)
    {
        const Legend legend = legendOf(studio, Who::Submission);
        Sheet sheet = againstReference(studio, sceneNamed("gradient_comparison", { 1060, 530 }));
        constexpr float lightColor = 0.8f; // of the scene's light
        const Shares shares = sharesOf(std::get<Slider>(sheet.panels.front()).after, legend, lightColor);
        sheet.panels.emplace_back(drawLegend(legend, lightColor));
        sheet.claims
            = { { fmt::format("Blinn-Phong contributes more on {:.0f} % of the surfaces, Phong on {:.1f} %: of one "
                              "shininess, Blinn-Phong's lobe is the wider.",
                      100.0 * shares.blinnPhong, 100.0 * shares.phong),
                shares.blinnPhong > shares.phong } };
        sheet.data = { { "phong", shares.phong }, { "equal", shares.equal }, { "blinn_phong", shares.blinnPhong } };
        return sheet;
    }

    constexpr double incidence = 40.0; // degrees

    // What leaves in each direction, of light that comes in from one side.
    std::vector<double> lobe(
        Studio& studio, Who who, ShadingModel model, float shininess, const std::vector<double>& angles)
    {
        std::vector<ShadingQuestion> questions;
        for (const double angle : angles)
            questions.push_back({ model, direction(incidence), direction(angle), shininess });
        std::vector<double> values;
        for (const glm::vec3& color : shade(studio, who, questions))
            values.push_back(color.x);
        return values;
    }

    // In degrees, of the part that is brighter than half of the brightest.
    double widthOf(const std::vector<std::vector<double>>& rows, std::size_t column)
    {
        double most = 0.0;
        for (const std::vector<double>& row : rows)
            most = std::max(most, row[column]);
        return static_cast<double>(
            std::ranges::count_if(rows, [&](const auto& row) { return row[column] > most / 2; }));
    }

    Sheet drawLobes(Studio& studio)
    {
        const std::vector<double> angles = evenly(-90.0, 90.0, 181);
        std::vector<std::vector<double>> rows;
        for (const double angle : angles)
            rows.push_back({ angle });
        double gap = 0.0;
        for (const float shininess : { 10.0f, 40.0f })
            for (const ShadingModel model : { ShadingModel::Phong, ShadingModel::BlinnPhong }) {
                const auto values = lobe(studio, Who::Submission, model, shininess, angles);
                const auto expected = lobe(studio, Who::Reference, model, shininess, angles);
                for (std::size_t i = 0; i < rows.size(); ++i) {
                    rows[i].push_back(values[i]);
                    gap = std::max(gap, std::abs(values[i] - expected[i]));
                }
            }
        const double widths[] = { widthOf(rows, 1), widthOf(rows, 2) };
        Sheet sheet;
        sheet.columns = 1;
        sheet.panels = { Plot { "Light that comes in 40° from the normal, and what leaves at each angle",
            dataBlock("lobes", rows) + R"plot(
set xrange [-90:90]; set yrange [0:1.05]; set xtics 30; set xlabel "angle from the normal, degrees"
set ylabel "specular term" offset 1; set key at graph 0.98, 0.97 right top
plot $lobes using 1:2 with lines linetype 1 title "Phong, shininess 10", \
     $lobes using 1:3 with lines linetype 2 title "Blinn-Phong, shininess 10", \
     $lobes using 1:4 with lines linetype 6 title "Phong, shininess 40", \
     $lobes using 1:5 with lines linetype 5 title "Blinn-Phong, shininess 40", \
     $lobes using 1:2:(sprintf("%g°: Phong %.3f, Blinn-Phong %.3f", $1, $2, $3)) every 5 with labels hypertext \
         point linetype 1 pointsize 0.3 notitle, \
     $lobes using 1:3:(sprintf("%g°: Phong %.3f, Blinn-Phong %.3f", $1, $2, $3)) every 5 with labels hypertext \
         point linetype 2 pointsize 0.3 notitle
)plot",
            { 720, 340 } } };
        sheet.facts = { { "samples", "181 angles" }, { "random numbers", "none" },
            { "largest difference to the reference", fmt::format("{:.2g}", gap) } };
        sheet.data = { { "rows", rows } };
        // An angle between mirrored ray and view is twice that between normal and halfway vector, in the plane of both.
        sheet.claims
            = { { fmt::format("At half its height Blinn-Phong's lobe is {:.0f}° wide and Phong's {:.0f}°, of the "
                              "same shininess.",
                      widths[1], widths[0]),
                widths[1] > 1.5 * widths[0] } };
        return sheet;
    }

    const Figure comparison("shading.comparison", "Phong against Blinn-Phong", Part::RenderedImages, drawComparison);
    const Figure lobes("shading.lobes", "The lobes of Phong and Blinn-Phong", Part::VisualDebugging, drawLobes);

}
}
