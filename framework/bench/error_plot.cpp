#include "bench/error_report.h"
#include "bench/plot.h"
#include <algorithm>
#include <cmath>
#include <fmt/core.h>

namespace bench {
namespace {

    using Abscissa = double (*)(const ErrorPoint&);

    // A line of the slope that it should have, through its point of 64 samples.
    PlotCurve theoryOf(const ErrorCurve& curve, Abscissa x, int look)
    {
        const ErrorPoint& middle = *std::ranges::find(curve.points, 64u, &ErrorPoint::numSamples);
        PlotCurve line { "", look, {} };
        for (const ErrorPoint& end : { curve.points.front(), curve.points.back() })
            line.points.push_back({ x(end), middle.error * std::pow(x(end) / x(middle), curve.theory) });
        return line;
    }

    PlotCurve measured(const ErrorCurve& curve, Abscissa x, int look)
    {
        PlotCurve line { fmt::format("{} {:.2f} (dashed: {:.2f})", curve.strategy, curve.slope.value, curve.theory),
            look, {} };
        for (const ErrorPoint& point : curve.points)
            line.points.push_back({ x(point), point.error });
        return line;
    }

    std::vector<PlotPanel> panelsOf(const std::vector<ErrorCurve>& curves, const std::string& xLabel, Abscissa x)
    {
        std::vector<PlotPanel> panels;
        for (const ErrorCurve& curve : curves) {
            if (panels.empty() || panels.back().title != curve.integrand)
                panels.push_back({ curve.integrand, xLabel, "root mean square error", {} });
            std::vector<PlotCurve>& lines = panels.back().curves;
            const int look = static_cast<int>(lines.size() / 2);
            lines.push_back(measured(curve, x, look));
            lines.push_back(theoryOf(curve, x, look));
        }
        return panels;
    }

}

void plot(const std::vector<ErrorCurve>& curves, const std::filesystem::path& folder)
{
    plot(folder, "error_by_samples",
        panelsOf(curves, "samples", [](const ErrorPoint& p) { return static_cast<double>(p.numSamples); }));
    plot(
        folder, "error_by_time", panelsOf(curves, "microseconds", [](const ErrorPoint& p) { return 1e6 * p.seconds; }));
}

}
