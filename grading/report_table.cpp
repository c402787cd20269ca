#include "grading/report.h"
#include <fmt/color.h>
#include <fmt/core.h>
#include <sstream>
#include <utility>

namespace grading {
namespace {

    constexpr std::size_t lineWidth = 110;

    fmt::text_style styleOf(Status status)
    {
        if (status == Status::Passed)
            return fmt::fg(fmt::terminal_color::green);
        return fmt::fg(status == Status::NotAttempted ? fmt::terminal_color::yellow : fmt::terminal_color::red);
    }

    // The message, indented, its lines broken between words.
    void printMessage(const std::string& message)
    {
        std::istringstream lines(message);
        for (std::string line; std::getline(lines, line);) {
            while (line.size() > lineWidth) {
                const std::size_t space = line.rfind(' ', lineWidth);
                const std::size_t end = space == std::string::npos || space == 0 ? lineWidth : space;
                fmt::print("      {}\n", line.substr(0, end));
                line.erase(0, line[end] == ' ' ? end + 1 : end);
            }
            fmt::print("      {}\n", line);
        }
    }

    void printRow(const Row& row, bool withColor, const std::string& previous)
    {
        if (row.hidden) {
            fmt::print("  {:<42} {:>19}\n", row.name, "hidden");
            return;
        }
        fmt::print("  {:<42} {:>5.4g} / {:<5.4g} ", row.name, row.score, row.maxScore);
        fmt::print(withColor ? styleOf(row.status) : fmt::text_style(), "{}\n", toText(row.status));
        if (const std::string explanation = explanationOf(row); !explanation.empty() && explanation != previous)
            printMessage(explanation);
    }

    void printObservations(const std::vector<Observation>& observations)
    {
        bool isFirst = true;
        for (const auto& [feature, drawn, expected] : observations) {
            if (drawn == expected)
                continue;
            if (std::exchange(isFirst, false))
                fmt::print("drawn (no points), where the solution draws something else\n");
            fmt::print("  {}\n", feature);
            for (const std::string& line : drawn)
                printMessage("drew      " + line);
            for (const std::string& line : expected)
                printMessage("solution  " + line);
        }
    }

}

void printTable(const Grade& grade, bool withColor)
{
    const std::vector<Row>& rows = grade.rows;
    for (const std::string& feature : featuresOf(rows)) {
        const Score total = totalOf(rows, feature);
        fmt::print("{:<44} {:>5.4g} / {:.4g}\n", feature, total.score, total.maxScore);
        std::string previous; // a file that does not compile says so once
        for (const Row& row : rowsOf(rows, feature)) {
            printRow(row, withColor, previous);
            previous = explanationOf(row);
        }
    }
    const Score total = totalOf(rows);
    fmt::print("{:<44} {:>5.4g} / {:.4g}\n", "total", total.score, total.maxScore);
    printObservations(grade.observations);
    if (!grade.notSandboxed.empty())
        fmt::print("not sandboxed: {}\n", grade.notSandboxed);
}

}
