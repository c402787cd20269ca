// Figures of what the tree costs and saves.
#include "debug/false_color.h"
#include "report/figure.h"
#include "report/pictures.h"
#include "report/plot.h"
#include "report/probes/tree_facts.h"
#include "report/studio.h"
#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace report::bvh_cost {
namespace {

    using debug::Quantity;

    std::vector<double> numbersOf(const worker::Rendering& rendering)
    {
        std::vector<double> numbers;
        for (const glm::vec3& pixel : rendering.pixels)
            numbers.push_back(pixel.x);
        return numbers;
    }

    // The colours of a heat map for gnuplot.
    std::string heatPalette()
    {
        std::string palette;
        for (int i = 0; i <= 16; ++i) {
            const glm::ivec3 c = glm::ivec3(debug::heat(static_cast<float>(i) / 16.0f) * 255.0f + 0.5f);
            palette += fmt::format("{}{} \"#{:02x}{:02x}{:02x}\"", i == 0 ? "" : ", ", i, c.x, c.y, c.z);
        }
        return fmt::format("set palette defined ({})\n", palette);
    }

    // The heat map's scale, as the histogram of what it shows.
    Plot scaleOf(const std::string& label, const std::vector<double>& numbers, float highest)
    {
        constexpr int numBars = 40;
        const double width = std::max(1.0, std::ceil(static_cast<double>(highest) / numBars));
        std::vector<std::vector<double>> rows(numBars + 1);
        for (std::size_t i = 0; i < rows.size(); ++i)
            rows[i] = { (static_cast<double>(i) + 0.5) * width, 0.0 };
        for (const double number : numbers)
            rows[std::min<std::size_t>(static_cast<std::size_t>(number / width), numBars)][1]
                += 100.0 / static_cast<double>(numbers.size());
        return { label,
            heatPalette() + dataBlock("bars", rows)
                + fmt::format("set cbrange [0:{0}]; set xrange [0:{0}]; set yrange [0.01:100]; set logscale y; set "
                              "format y '%g'; set style fill solid 1; unset key\n"
                              "set xlabel 'nodes visited by a ray; the last bar: more'; set ylabel '% of pixels'\n"
                              "set colorbox horizontal user origin graph 0, graph 1.04 size graph 1, 0.04 noborder\n"
                              "set cbtics scale 0 format ''; set tmargin 3; set boxwidth {1}\n"
                              "plot $bars using 1:2:1 with boxes linecolor palette, {2}",
                    highest, width, hoverPoints("bars", 9, "%.0f nodes: %.2f %%")),
            { 520, 260 } };
    }

    // All but one in a thousand are at most that: few are so large that a scale with all of them would be dark.
    double aboveNearlyAll(std::vector<double> numbers)
    {
        const auto place = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() - 1 - numbers.size() / 1000);
        std::ranges::nth_element(numbers, place);
        return std::max(1.0, *place);
    }

    Picture heatMap(const std::string& label, const worker::Rendering& rendering, const debug::Range& range)
    {
        return { label, rendering.size, debug::falseColors(Quantity::NodesVisited, rendering.pixels, range) };
    }

    Sheet drawHeat(Studio& studio)
    {
        auto request = sceneNamed("dragon", { 520, 390 });
        const auto tree = studio.ask<TreeFacts>(Who::Submission, "figures.tree", request);
        request.quantity = Quantity::NodesVisited;
        const worker::Rendering own = studio.render(Who::Submission, request);
        const worker::Rendering expected = studio.render(Who::Reference, request);
        const std::vector<double> numbers = numbersOf(own), theirs = numbersOf(expected);
        const double most = std::ranges::max(numbers);
        const debug::Range range { 0.0f,
            static_cast<float>(std::max(aboveNearlyAll(numbers), aboveNearlyAll(theirs))) };
        const auto mean = [](const std::vector<double>& values) {
            return std::reduce(values.begin(), values.end()) / static_cast<double>(values.size());
        };

        Sheet sheet { .panels
            = { heatMap(studio.nameOf(Who::Submission), own, range), heatMap("reference", expected, range),
                scaleOf(studio.nameOf(Who::Submission), numbers, range.highest),
                scaleOf("reference", theirs, range.highest) },
            .facts = factsOf(request, own) };
        sheet.claims = {
            { fmt::format("Of {} nodes a ray visits {:.1f} in the mean and {:.0f} at most, {:.2f} %; with the "
                          "reference {:.1f} in the mean.",
                  tree.numNodes, mean(numbers), most, 100.0 * most / static_cast<double>(tree.numNodes), mean(theirs)),
                most > 0.0 && most < 0.01 * static_cast<double>(tree.numNodes) }
        };
        sheet.data = { { "mean", mean(numbers) }, { "most", most }, { "nodes", tree.numNodes },
            { "reference mean", mean(theirs) } };
        return sheet;
    }

    struct Cost {
        TreeFacts tree;
        double own = 0.0, reference = 0.0; // seconds of a picture
    };

    Cost costOf(Studio& studio, const std::string& scene)
    {
        const auto request
            = sceneNamed(scene, { 400, 300 }, { "shadows=false", "reflections=false", "shadow_samples=1" });
        return { studio.ask<TreeFacts>(Who::Submission, "figures.tree", request),
            studio.render(Who::Submission, request).seconds, studio.render(Who::Reference, request).seconds };
    }

    Sheet drawTable(Studio& studio)
    {
        Table table { "pictures of 400 × 300 pixels of one ray each, without shadows and reflections, in milliseconds",
            { "scene", "triangles", "levels", "leaves", "triangles a leaf", "build", studio.nameOf(Who::Submission),
                "reference" },
            {} };
        Sheet sheet { .columns = 1 };
        std::vector<Cost> costs;
        for (const std::string scene : { "single_triangle", "cube", "cornell_box", "monkey", "teapot", "dragon" }) {
            const auto& [tree, own, reference] = costs.emplace_back(costOf(studio, scene));
            const double perLeaf = static_cast<double>(tree.numTriangles) / std::max(tree.numLeaves, 1u);
            table.rows.push_back({ scene, fmt::format("{}", tree.numTriangles), fmt::format("{}", tree.numLevels),
                fmt::format("{}", tree.numLeaves), fmt::format("{:.2f}", perLeaf),
                fmt::format("{:.2f}", 1e3 * tree.buildSeconds), fmt::format("{:.1f}", 1e3 * own),
                fmt::format("{:.1f}", 1e3 * reference) });
            sheet.data.push_back({ { "scene", scene }, { "triangles", tree.numTriangles }, { "levels", tree.numLevels },
                { "leaves", tree.numLeaves }, { "seconds", own } });
        }
        sheet.panels = { table };
        sheet.facts = { { "samples", "1 a pixel" }, { "seed", "0" } };
        const double triangles
            = static_cast<double>(costs.back().tree.numTriangles) / static_cast<double>(costs[1].tree.numTriangles);
        const double slower = costs.back().own / costs[1].own;
        sheet.claims
            = { { fmt::format("The dragon has {:.0f} times the triangles of the cube; its picture takes {:.1f} "
                              "times as long.",
                      triangles, slower),
                slower < triangles / 10.0 } };
        return sheet;
    }

    const Figure heat("bvh.heat", "Nodes visited by the ray through each pixel", Part::RenderedImages, drawHeat);
    const Figure table("bvh.table", "Trees and times", Part::VisualDebugging, drawTable);

}
}
