#include "report/plot.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace report {

// Colours of lines: Okabe and Ito 2008, "Color Universal Design".
const std::string& plotPrelude()
{
    static const std::string prelude = R"(reset
set encoding utf8
set border 3 linecolor rgb "#5d6878" linewidth 0.8
set tics nomirror scale 0.6 textcolor rgb "#5d6878"
set xlabel textcolor rgb "#1b2330"
set ylabel textcolor rgb "#1b2330"
set key textcolor rgb "#1b2330" samplen 2 spacing 1.15
set grid linecolor rgb "#98a4b5" linewidth 0.4 dashtype 3
set linetype 1 linecolor rgb "#0072b2" linewidth 2 pointtype 7 pointsize 0.7
set linetype 2 linecolor rgb "#d55e00" linewidth 2 pointtype 5 pointsize 0.7
set linetype 3 linecolor rgb "#009e73" linewidth 2 pointtype 9 pointsize 0.9
set linetype 4 linecolor rgb "#cc79a7" linewidth 2 pointtype 11 pointsize 0.9
set linetype 5 linecolor rgb "#e69f00" linewidth 2 pointtype 13 pointsize 0.9
set linetype 6 linecolor rgb "#56b4e9" linewidth 2 pointtype 6 pointsize 0.7
set linetype 7 linecolor rgb "#7f7f7f" linewidth 2 pointtype 4 pointsize 0.7
set linetype 8 linecolor rgb "#f0e442" linewidth 2 pointtype 8 pointsize 0.9
set linetype 9 linecolor rgb "#ff000000" pointtype 7 pointsize 1.5
)";
    return prelude;
}

std::string dataBlock(const std::string& name, const std::vector<std::vector<double>>& rows)
{
    std::string block = fmt::format("${} << EOD\n", name);
    for (const std::vector<double>& row : rows)
        block += fmt::format("{:.9g}\n", fmt::join(row, " "));
    return block + "EOD\n";
}

std::string hoverPoints(const std::string& name, int style, const std::string& format)
{
    return fmt::format(
        "${} using 1:2:(sprintf(\"{}\", $1, $2)) with labels hypertext point linetype {} notitle", name, format, style);
}

std::string quoted(const std::string& text)
{
    std::string word = "'";
    for (const char c : text)
        word += c == '\'' ? std::string("''") : std::string(1, c);
    return word + "'";
}

}
