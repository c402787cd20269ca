// Hard and soft shadows: the same objects below a point light, a segment light and a parallelogram light.
#include "report/figure.h"
#include "report/pictures.h"
#include "report/plot.h"
#include "report/studio.h"
#include <fmt/format.h>

namespace report::light {
namespace {

    struct Kind {
        const char* name; // of the scene light_<name>, too
        const char* title;
    };
    constexpr Kind kinds[] = { { "point", "Point" }, { "segment", "Segment" }, { "parallelogram", "Parallelogram" } };

    worker::RenderRequest requestOf(const Kind& kind, glm::ivec2 size)
    {
        return sceneNamed(std::string("light_") + kind.name, size, { "shadow_samples=32" });
    }

    Sheet besideReference(Studio& studio)
    {
        Sheet sheet;
        sheet.columns = 3;
        for (const Kind& kind : kinds) {
            const worker::RenderRequest request = requestOf(kind, { 360, 270 });
            const worker::Rendering own = studio.render(Who::Submission, request);
            const Picture picture = toPicture(studio.nameOf(Who::Submission), own);
            const Picture reference
                = toPicture(std::string(kind.title) + ", reference", studio.render(Who::Reference, request));
            const std::string numbers = fmt::format("light_{}.toml, {}, {:.2f} s, RMSE against the reference {:.2g}",
                kind.name, samplesOf(request), own.seconds, rmse(reference, picture));
            sheet.facts.push_back({ kind.title, numbers });
            sheet.panels.emplace_back(Slider { reference, picture });
            sheet.data[kind.name] = rmse(reference, picture);
        }
        sheet.facts.push_back({ "seed", "0" });
        return sheet;
    }

    // ---- How much of the light each pixel's point sees

    // Where there is light at all; elsewhere -1.
    std::vector<double> visibleShares(const worker::Rendering& shadows, const worker::Rendering& noShadows)
    {
        std::vector<double> shares;
        for (std::size_t i = 0; i < shadows.pixels.size(); ++i) {
            const double lit = noShadows.pixels[i].y;
            shares.push_back(lit > 0.05 ? shadows.pixels[i].y / lit : -1.0);
        }
        return shares;
    }

    std::size_t numInPenumbra(const std::vector<double>& shares)
    {
        return static_cast<std::size_t>(
            std::ranges::count_if(shares, [](double share) { return share > 0.02 && share < 0.98; }));
    }

    // Along one row of pixels, which crosses shadows.
    std::vector<std::vector<double>> alongRow(const std::vector<double>& shares, glm::ivec2 size, int row)
    {
        std::vector<std::vector<double>> points;
        for (int x = 0; x < size.x; ++x)
            points.push_back({ static_cast<double>(x), shares[static_cast<std::size_t>(row * size.x + x)] });
        return points;
    }

    Sheet hardAgainstSoft(Studio& studio)
    {
        constexpr glm::ivec2 size { 520, 390 };
        constexpr int row = 215;
        std::vector<Picture> pictures;
        std::vector<std::size_t> penumbras;
        std::string blocks, lines;
        for (const Kind& kind : kinds) {
            worker::RenderRequest request = requestOf(kind, size);
            worker::Rendering shadows = studio.render(Who::Submission, request);
            request.settings.emplace_back("shadows=false");
            const auto shares = visibleShares(shadows, studio.render(Who::Submission, request));
            penumbras.push_back(numInPenumbra(shares));
            blocks += dataBlock(kind.name, alongRow(shares, size, row));
            lines += fmt::format("{0} ${1} using 1:($2 < 0 ? NaN : $2) with lines linetype {2} title \"{1}\", {3}",
                pictures.empty() ? "plot" : ",", kind.name, pictures.size() + 1,
                hoverPoints(kind.name, 9, std::string(kind.name) + ", pixel %g: %.2f"));
            pictures.push_back(toPicture(std::string(kind.title) + " light", std::move(shadows)));
        }
        const Picture reference = toPicture("reference", studio.render(Who::Reference, requestOf(kinds[2], size)));
        const double error = rmse(reference, pictures[2]);
        for (Picture& picture : pictures)
            for (int x = 0; x < size.x; x += x % 12 < 6 ? 1 : 7) // the row of the plot, dashed
                picture.pixels[static_cast<std::size_t>(row * size.x + x)] = glm::vec3(1.0f, 0.85f, 0.2f);
        Sheet sheet;
        sheet.panels = { Slider { pictures[0], pictures[2] },
            Plot { "What points see of each light, along the dashed row across the border of the cube's shadow",
                blocks
                    + "set xlabel \"pixel of the row\"; set ylabel \"visible part of the light\"\n"
                      "set yrange [-0.03:1.03]; set xrange [45:130]; set key bottom left\n"
                    + lines,
                { 520, 390 } } };
        sheet.facts = { { "scenes", "light_point.toml, light_segment.toml, light_parallelogram.toml" },
            { "samples", samplesOf(requestOf(kinds[2], size)) }, { "seed", "0" },
            { "RMSE of the parallelogram's shadow against the reference", fmt::format("{:.2g}", error) } };
        sheet.claims = { { fmt::format("In a shadow's border, where more than 2 % and less than 98 % of the light is "
                                       "visible, lie {} pixels below the point light, {} below the segment, {} below "
                                       "the parallelogram.",
                               penumbras[0], penumbras[1], penumbras[2]),
            penumbras[0] == 0 && penumbras[1] > 0 && penumbras[2] > 0 } };
        sheet.data = { { "penumbra", penumbras } };
        return sheet;
    }

    const Figure beside(
        "light.kinds", "A point, a segment and a parallelogram light", Part::RenderedImages, besideReference);
    const Figure soft("light.hard_and_soft", "Hard and soft shadows", Part::RenderedImages, hardAgainstSoft);

}
}
