#include "bench/plot.h"
#include "files/error.h"
#include "files/text.h"
#include <cstring>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bench {
namespace {

    // Okabe and Ito 2008, "Color Universal Design": told apart by nearly everybody; markers tell them apart in grey.
    constexpr struct {
        const char* color;
        int marker;
    } looks[] = { { "#000000", 7 }, { "#d55e00", 5 }, { "#0072b2", 9 }, { "#cc79a7", 13 } };

    std::string quoted(const std::string& text)
    {
        std::string result = "'";
        for (const char c : text)
            result += c == '\'' ? "''" : std::string(1, c);
        return result + "'";
    }

    std::string dataOf(const PlotCurve& curve, const std::string& name)
    {
        std::string text = fmt::format("${} << END\n", name);
        for (const PlotPoint& point : curve.points)
            text += fmt::format("{:.6g} {:.6g}\n", point.x, point.y);
        return text + "END\n";
    }

    std::string lineOf(const PlotCurve& curve, const std::string& name)
    {
        const auto& look = looks[static_cast<std::size_t>(curve.look) % std::size(looks)];
        if (curve.title.empty())
            return fmt::format("${} with lines lc rgb '{}' lw 0.7 dt 2 notitle", name, look.color);
        return fmt::format("${} with linespoints lc rgb '{}' lw 2 pt {} ps 1 title {}", name, look.color, look.marker,
            quoted(curve.title));
    }

    std::string drawingOf(const PlotPanel& panel, std::size_t index)
    {
        std::string data, lines;
        for (std::size_t i = 0; i < panel.curves.size(); ++i) {
            const std::string name = fmt::format("panel{}curve{}", index, i);
            data += dataOf(panel.curves[i], name);
            lines += (i == 0 ? "plot " : ", ") + lineOf(panel.curves[i], name);
        }
        return data
            + fmt::format("set title {} noenhanced\nset xlabel {} noenhanced\nset ylabel {} noenhanced\n{}\n",
                quoted(panel.title), quoted(panel.xLabel), quoted(panel.yLabel), lines);
    }

    // Once for each of gnuplot's terminals.
    std::string pictureOf(const std::string& terminal, const std::string& file, const std::vector<PlotPanel>& panels)
    {
        const std::size_t numRows = (panels.size() + 1) / 2;
        std::string text = fmt::format("set terminal {} size 1200,{} background rgb 'white'\nset output {}\n"
                                       "set multiplot layout {},{}\n",
            terminal, 450 * numRows, quoted(file), numRows, std::min<std::size_t>(panels.size(), 2));
        for (std::size_t i = 0; i < panels.size(); ++i)
            text += drawingOf(panels[i], i);
        return text + "unset multiplot\nunset output\n";
    }

    void runGnuplot(const std::filesystem::path& script)
    {
        std::string program = "gnuplot", argument = script.string();
        char* arguments[] = { program.data(), argument.data(), nullptr };
        pid_t process = 0;
        if (const int error = posix_spawnp(&process, "gnuplot", nullptr, nullptr, arguments, environ))
            throw files::Error(script, fmt::format("cannot run gnuplot: {}", std::strerror(error)));
        int status = 0;
        if (waitpid(process, &status, 0) != process || status != 0)
            throw files::Error(script, "gnuplot cannot draw this");
    }

}

void plot(const std::filesystem::path& folder, const std::string& name, const std::vector<PlotPanel>& panels)
{
    std::filesystem::create_directories(folder);
    const std::string path = (folder / name).string();
    const std::string settings = "set logscale xy\nset format '10^{%T}'\nset grid lc rgb '#dddddd' lt 1\n"
                                 "set key left bottom Left reverse noenhanced samplen 2\n";
    files::writeText(path + ".gnuplot",
        settings + pictureOf("svg", path + ".svg", panels) + pictureOf("pngcairo", path + ".png", panels));
    runGnuplot(path + ".gnuplot");
}

}
