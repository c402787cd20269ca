#include "grading/checks/render_places.h"
#include "grading/chi_square.h"
#include "grading/expect.h"
#include <fmt/format.h>
#include <glm/common.hpp>

namespace grading {
namespace {

    // Deviations that chance exceeds with probability 4e-8, either way; there are ten tests.
    constexpr double significant = 5.5;

    void expectChance(const std::string& asked, double deviations, const std::string& which)
    {
        expect(deviations < significant, asked,
            fmt::format("{} {:.0f} standard deviations too uneven", which, deviations), "independent uniform ones");
        expect(deviations > -significant, asked,
            fmt::format("{} {:.0f} standard deviations too even", which, -deviations), "independent ones, which clump");
    }

    // Of the rays of all pixels together.
    void expectUniform(const std::string& asked, const std::vector<Places>& pixels, int columns, int rows)
    {
        Places all;
        for (const Places& places : pixels)
            all.insert(all.end(), places.begin(), places.end());
        expectChance(asked, unevenness(countCells(all, columns, rows)),
            fmt::format("positions in {} x {} cells", columns, rows));
    }

    // Of the rays within each pixel: a grid is too even, a number used twice too uneven.
    void expectClumps(const std::string& asked, const std::vector<Places>& pixels, int columns, int rows)
    {
        std::vector<std::vector<int>> counts;
        for (const Places& places : pixels)
            counts.push_back(countCells(places, columns, rows));
        expectChance(asked, unevennessWithin(counts),
            fmt::format("a pixel's positions, in {} x {} cells of each pixel,", columns, rows));
    }

    // A coordinate of every other ray beside one of the ray that follows.
    void expectUnrelated(const std::string& asked, const std::vector<Places>& pixels, int first, int second)
    {
        constexpr int cells = 8;
        const auto name = [](int coordinate) { return coordinate == 0 ? 'x' : 'y'; };
        Places pairs;
        for (const Places& places : pixels)
            for (std::size_t i = 0; i + 1 < places.size(); i += 2)
                pairs.emplace_back(places[i][first], places[i + 1][second]);
        expectChance(asked, unevenness(countCells(pairs, cells, cells)),
            fmt::format("pairs of a ray's {} and the next ray's {}", name(first), name(second)));
    }

}

std::vector<int> countCells(const Places& places, int columns, int rows)
{
    std::vector<int> counts(static_cast<std::size_t>(columns * rows), 0);
    for (const glm::dvec2& place : places) {
        const glm::ivec2 last(columns - 1, rows - 1);
        const glm::ivec2 cell(glm::clamp(place * glm::dvec2(columns, rows), glm::dvec2(0.0), glm::dvec2(last)));
        ++counts[static_cast<std::size_t>(cell.y * columns + cell.x)];
    }
    return counts;
}

void expectIndependent(const std::string& asked, const std::vector<Places>& pixels)
{
    expectUniform(asked, pixels, 4, 4);
    expectUniform(asked, pixels, 13, 13);
    expectUniform(asked, pixels, 64, 1);
    expectUniform(asked, pixels, 1, 64);
    // As many cells as a pixel has rays: a jittered grid and rooks have one in each.
    expectClumps(asked, pixels, 4, 4);
    expectClumps(asked, pixels, 16, 1);
    expectClumps(asked, pixels, 1, 16);
    expectUnrelated(asked, pixels, 0, 0);
    expectUnrelated(asked, pixels, 1, 1);
    expectUnrelated(asked, pixels, 1, 0);
}

}
