#include "grading/report.h"
#include "grading/write_whole.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace grading {
namespace {

    using Json = nlohmann::ordered_json;

    Json toTest(const Row& row, const std::string& number)
    {
        const bool passed = row.status == Status::Passed;
        const bool silent = passed || row.hidden;
        return { { "name", row.name }, { "name_format", "text" }, { "number", number }, { "score", row.score },
            { "max_score", row.maxScore }, { "status", passed ? "passed" : "failed" },
            { "output", silent ? "" : fmt::format("{}: {}", toText(row.status), explanationOf(row)) },
            { "output_format", "text" }, { "tags", { row.feature } },
            { "visibility", row.hidden ? "hidden" : "visible" } };
    }

    std::string summaryOf(const std::vector<Row>& rows)
    {
        std::string summary;
        for (const std::string& feature : featuresOf(rows)) {
            const Score total = totalOf(rows, feature);
            summary += fmt::format("{}: {:.4g} of {:.4g}\n", feature, total.score, total.maxScore);
        }
        return summary;
    }

}

void writeGradescope(const std::filesystem::path& path, const Grade& grade)
{
    const std::vector<Row>& rows = grade.rows;
    Json tests = Json::array();
    int featureNumber = 0;
    for (const std::string& feature : featuresOf(rows)) {
        ++featureNumber;
        int checkNumber = 0;
        for (const Row& row : rowsOf(rows, feature))
            tests.push_back(toTest(row, fmt::format("{}.{}", featureNumber, ++checkNumber)));
    }
    const Score total = totalOf(rows);
    const Json results = { { "score", total.score }, { "execution_time", grade.seconds }, { "output", summaryOf(rows) },
        { "output_format", "text" }, { "visibility", "visible" }, { "stdout_visibility", "hidden" },
        { "extra_data", { { "max_score", total.maxScore } } }, { "tests", tests } };
    writeWhole(path, results.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}
