#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace bench {

struct PlotPoint {
    double x, y; // above zero
};

struct PlotCurve {
    std::string title; // in the key; empty: a thin line that the key leaves out
    int look = 0; // colour and marker, from 0 on
    std::vector<PlotPoint> points;
};

// Both axes are logarithmic.
struct PlotPanel {
    std::string title, xLabel, yLabel;
    std::vector<PlotCurve> curves;
};

// Draws the panels, two in a row, as name.svg and name.png of the folder, by gnuplot; what it was told stays there as
// name.gnuplot. Throws files::Error, also where there is no gnuplot.
void plot(const std::filesystem::path& folder, const std::string& name, const std::vector<PlotPanel>& panels);

}
