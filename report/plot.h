#pragma once
#include "report/sheet.h"
#include <span>
#include <string>
#include <vector>

namespace report {

// Scripts of plots are gnuplot's own commands. Before them stands plotPrelude: fonts, borders, the line styles 1 to 8,
// which colour-blind readers tell apart (linetype 1 is blue, 2 vermilion, 3 green, ...), and 9, which nobody sees.

// Commands that every script starts with.
[[nodiscard]] const std::string& plotPrelude();

// "$name << EOD ... EOD": rows of numbers, for `plot $name using 1:2`.
[[nodiscard]] std::string dataBlock(const std::string& name, const std::vector<std::vector<double>>& rows);

// An element of a plot command: points of a block, columns 1 and 2, whose values show when pointed at.
// style: number of the line style.
[[nodiscard]] std::string hoverPoints(const std::string& name, int style, const std::string& format = "%.3g, %.3g");

// Two in one: a title's text between single quotes, for names that somebody chose.
[[nodiscard]] std::string quoted(const std::string& text);

}
