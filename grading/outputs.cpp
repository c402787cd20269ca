#include "grading/outputs.h"
#include "files/error.h"
#include "grading/check.h"
#include "grading/report.h"
#include <algorithm>
#include <fnmatch.h>

namespace grading {
namespace {

    bool matches(const std::string& name, const std::string& pattern)
    {
        return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
    }

}

void expectPatternsMatch(const std::vector<std::string>& patterns, const std::vector<std::string>& otherRows)
{
    std::vector<std::string> names = otherRows;
    for (const Check& check : Check::all())
        names.push_back(check.name);
    for (const std::string& pattern : patterns)
        if (std::ranges::none_of(names, [&](const std::string& name) { return matches(name, pattern); }))
            throw files::Error(
                "--hide", "found '" + pattern + "', which matches no check, expected one like 'light.*'");
}

std::vector<Row> hide(std::vector<Row> rows, const std::vector<std::string>& patterns)
{
    for (Row& row : rows) {
        row.hidden
            = std::ranges::any_of(patterns, [&](const std::string& pattern) { return matches(row.name, pattern); });
        if (!row.hidden)
            continue;
        row.message.clear();
        row.usualCause.clear();
        row.pictures.reset();
    }
    return rows;
}

std::vector<Observation> hide(std::vector<Observation> observations, const std::vector<Row>& rows)
{
    std::erase_if(observations, [&](const Observation& observation) {
        return std::ranges::any_of(
            rows, [&](const Row& row) { return row.hidden && row.feature == observation.feature; });
    });
    return observations;
}

void writeOutputs(const Outputs& outputs, const Grade& grade)
{
    if (!outputs.json.empty())
        writeJson(outputs.json, grade);
    if (!outputs.junit.empty())
        writeJunit(outputs.junit, grade);
    if (!outputs.gradescope.empty())
        writeGradescope(outputs.gradescope, grade);
    if (!outputs.html.empty())
        writeHtml(outputs.html, grade);
}

}
