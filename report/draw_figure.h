#pragma once
#include "report/figure.h"
#include "report/studio.h"

namespace report {

struct DrawnFigure {
    nlohmann::json description; // see figure_file.h
    bool isNew = true;
};

// Draws a figure into the folder unless what lies there was drawn from the same. A submission's failure is part of the
// figure and harms no other.
[[nodiscard]] DrawnFigure drawFigure(const Figure& figure, const Subject& subject, const std::filesystem::path& folder);

// Whether the results that it shows are there.
[[nodiscard]] bool canBeDrawn(const Figure& figure, const Subject& subject);

}
