#pragma once
#include "report/figure.h"
#include "report/studio.h"

namespace report {

// Draws a figure into the folder unless what lies there was drawn from the same; returns what figure_file.h describes.
// A submission's failure is part of the figure and harms no other.
nlohmann::json drawFigure(const Figure& figure, const Subject& subject, const std::filesystem::path& folder);

// Whether the results that it shows are there.
[[nodiscard]] bool canBeDrawn(const Figure& figure, const Subject& subject);

}
