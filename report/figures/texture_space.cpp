#include "report/figures/texture_space.h"
#include "report/plot.h"
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace report {
namespace {

    // Up to so many texels each way around the lookup.
    constexpr int reach = 3;

    glm::vec2 placeOf(const worker::TextureLookup& lookup)
    {
        return lookup.texCoord * glm::vec2(lookup.size);
    }

    // A row a texel: its centre and its colour as 0xRRGGBB.
    std::vector<std::vector<double>> cellsOf(const Image& image, glm::ivec2 first, glm::ivec2 end)
    {
        std::vector<std::vector<double>> cells;
        for (int y = first.y; y < end.y; ++y)
            for (int x = first.x; x < end.x; ++x) {
                const glm::ivec3 c { image.get_pixel(y * image.width + x) * 255.0f + 0.5f };
                cells.push_back({ x + 0.5, y + 0.5, static_cast<double>(c.x << 16 | c.y << 8 | c.z) });
            }
        return cells;
    }

    // The weight stands on the far side of the texel's centre, so that it leaves the place free.
    std::string outlineOf(const debug::Texel& texel, const glm::vec2& place)
    {
        const glm::ivec2 a = texel.index, b = a + 1;
        const glm::vec2 centre = glm::vec2(a) + 0.5f;
        const auto rectangle = [&](const char* color, int width) {
            return fmt::format(
                "set object rectangle from {},{} to {},{} front fillstyle empty border linecolor rgb '{}' "
                "linewidth {}\n",
                a.x, a.y, b.x, b.y, color, width);
        };
        const float height = centre.y + (centre.y < place.y ? -0.3f : 0.3f);
        // A box of the label's own lies over its text in SVG.
        return rectangle("black", 5) + rectangle("white", 2)
            + fmt::format(
                "set object rectangle center {0},{1} size 0.84,0.26 front fillcolor rgb 'white' fillstyle solid "
                "noborder\nset label '{2:.3f}' at {0},{1} center front textcolor rgb '#101010'\n",
                centre.x, height, texel.weight);
    }

    // As labels, which lie over the outlines.
    std::string crossAt(const glm::vec2& place)
    {
        const auto cross = [&](const char* color, int width) {
            return fmt::format(
                "set label '' at {},{} front point pointtype 2 pointsize 2 linewidth {} linecolor rgb '{}'\n", place.x,
                place.y, width, color);
        };
        return cross("black", 6) + cross("white", 2);
    }

}

Plot textureSpace(const std::string& label, const worker::TextureLookup& lookup, const Scene& scene)
{
    const Image& image = *scene.textures.at(lookup.texture);
    const glm::ivec2 size { image.width, image.height };
    const glm::vec2 place = placeOf(lookup);
    const glm::ivec2 middle = glm::clamp(glm::ivec2(glm::floor(place)), glm::ivec2(0), size - 1);
    const glm::ivec2 first = glm::max(middle - reach, glm::ivec2(0)), end = glm::min(middle + reach + 1, size);
    std::string script = dataBlock("texels", cellsOf(image, first, end))
        + fmt::format("set xrange [{}:{}]; set yrange [{}:{}]; set size ratio -1; unset grid; unset key\n"
                      "set xlabel 'u · {}'; set ylabel 'v · {}'; set tics 1; set style fill solid 1 noborder\n",
            first.x, end.x, first.y, end.y, size.x, size.y);
    for (const debug::Texel& texel : lookup.texels)
        script += outlineOf(texel, place);
    script += crossAt(place) + R"gp(plot $texels using 1:2:(0.5):(0.5):3 with boxxyerror linecolor rgb variable, \
    $texels using 1:2:(sprintf("texel %d, %d: #%06x", $1, $2, $3)) with labels hypertext point linetype 9
)gp";
    return { label, script, { 520, 400 } };
}

float distanceOfMean(const worker::TextureLookup& lookup)
{
    glm::vec2 mean { 0.0f };
    for (const debug::Texel& texel : lookup.texels)
        mean += texel.weight * (glm::vec2(texel.index) + 0.5f);
    return glm::distance(mean, placeOf(lookup));
}

float sumOfWeights(const worker::TextureLookup& lookup)
{
    float sum = 0.0f;
    for (const debug::Texel& texel : lookup.texels)
        sum += texel.weight;
    return sum;
}

}
