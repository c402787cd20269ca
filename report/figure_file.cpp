#include "report/figure_file.h"
#include "debug/raster.h"
#include "debug/svg.h"
#include "files/bitmap.h"
#include "files/text.h"
#include "report/plot.h"
#include "report/program.h"
#include <fmt/format.h>

namespace report {
namespace {

    using nlohmann::json;
    namespace fs = std::filesystem;

    void writeBytes(const fs::path& path, const std::vector<std::byte>& bytes)
    {
        files::writeText(path, { reinterpret_cast<const char*>(bytes.data()), bytes.size() });
    }

    // Where a panel's files go: the path without its extension.
    class PanelFiles {
    public:
        PanelFiles(fs::path folder, std::string stem)
            : m_folder(std::move(folder))
            , m_stem(std::move(stem))
        {
        }

        [[nodiscard]] std::string name(const char* extension) const { return m_stem + extension; }
        [[nodiscard]] fs::path path(const char* extension) const { return m_folder / name(extension); }
        [[nodiscard]] PanelFiles part(const char* suffix) const { return { m_folder, m_stem + suffix }; }

    private:
        fs::path m_folder;
        std::string m_stem;
    };

    json describe(const char* kind, const std::string& label, glm::ivec2 size, const PanelFiles& files)
    {
        return { { "kind", kind }, { "label", label }, { "png", files.name(".png") }, { "width", size.x },
            { "height", size.y } };
    }

    json save(const Picture& picture, const PanelFiles& files)
    {
        writeBytes(files.path(".png"), files::encodePng(picture.size, picture.pixels));
        return describe("picture", picture.label, picture.size, files);
    }

    json save(const Drawing& drawing, const PanelFiles& files)
    {
        const Picture& under = drawing.picture;
        std::vector<glm::vec3> pixels = under.pixels;
        debug::drawOver(pixels, under.size, drawing.strokes);
        writeBytes(files.path(".png"), files::encodePng(under.size, pixels));
        files::writeText(
            files.path(".svg"), debug::toSvg(drawing.strokes, under.size, files::encodePng(under.size, under.pixels)));
        json panel = describe("drawing", under.label, under.size, files);
        panel["svg"] = files.name(".svg");
        return panel;
    }

    // The PNG has twice as many pixels, for paper.
    json save(const Plot& plot, const PanelFiles& files)
    {
        const glm::ivec2 size = plot.size;
        files::writeText(files.path(".gnuplot"), plotPrelude() + plot.script);
        runProgram({ "gnuplot", "-e",
            fmt::format("set terminal svg size {},{} dynamic font 'DejaVu Sans,12'; set output {}", size.x, size.y,
                quoted(files.path(".svg").string())),
            files.path(".gnuplot").string(), "-e",
            fmt::format("set terminal pngcairo size {},{} font 'DejaVu Sans,12' fontscale 2 linewidth 2 pointscale 2; "
                        "set output {}",
                2 * size.x, 2 * size.y, quoted(files.path(".png").string())),
            files.path(".gnuplot").string() });
        json panel = describe("plot", plot.label, 2 * size, files);
        panel["svg"] = files.name(".svg");
        return panel;
    }

    json save(const Slider& slider, const PanelFiles& files)
    {
        return { { "kind", "slider" }, { "before", save(slider.before, files.part("-before")) },
            { "after", save(slider.after, files.part("-after")) } };
    }

    json save(const Table& table, const PanelFiles&)
    {
        return { { "kind", "table" }, { "label", table.label }, { "head", table.head }, { "rows", table.rows } };
    }

}

json saveSheet(const fs::path& folder, const std::string& name, const Sheet& sheet)
{
    json panels = json::array();
    for (const Panel& panel : sheet.panels) {
        const PanelFiles files { folder, fmt::format("{}.{}", name, panels.size() + 1) };
        panels.push_back(std::visit([&](const auto& one) { return save(one, files); }, panel));
    }
    json facts = json::array(), claims = json::array();
    for (const Fact& fact : sheet.facts)
        facts.push_back({ fact.name, fact.value });
    for (const Claim& claim : sheet.claims)
        claims.push_back({ { "text", claim.text }, { "holds", claim.holds } });
    return { { "columns", sheet.columns }, { "panels", panels }, { "facts", facts }, { "claims", claims },
        { "data", sheet.data } };
}

}
