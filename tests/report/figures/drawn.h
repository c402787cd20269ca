#pragma once
#include "report/figure.h"
#include <debug/projection.h>
#include <string>

namespace report_test {

// What a figure shows of the reference, drawn now.
[[nodiscard]] report::Sheet drawn(const std::string& figure);

// What the claims of a sheet say that does not hold; empty if all of them do. Without claims, that.
[[nodiscard]] std::string brokenClaim(const report::Sheet& sheet);

// The panel in that place; throws if it is of another kind.
template <typename Panel> [[nodiscard]] const Panel& panelOf(const report::Sheet& sheet, std::size_t index)
{
    return std::get<Panel>(sheet.panels.at(index));
}

// Of a scene's own camera.
[[nodiscard]] debug::Projection projectionOf(const std::string& scene, glm::ivec2 size);

// Calls what(pixel, index) for all pixels of a picture of that size.
template <typename What> void forEachPixel(glm::ivec2 size, const What& what)
{
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            what(glm::ivec2(x, y),
                static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x));
}

}
