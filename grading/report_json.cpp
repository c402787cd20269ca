#include "grading/report.h"
#include "grading/write_whole.h"
#include <nlohmann/json.hpp>

namespace grading {
namespace {

    using Json = nlohmann::ordered_json;

    Json toJson(const Score& score)
    {
        return { { "score", score.score }, { "max_score", score.maxScore } };
    }

    Json toJson(const Row& row)
    {
        if (row.hidden)
            return { { "name", row.name }, { "feature", row.feature }, { "hidden", true } };
        return { { "name", row.name }, { "feature", row.feature }, { "score", row.score },
            { "max_score", row.maxScore }, { "status", std::string(toText(row.status)) },
            { "message", explanationOf(row) } };
    }

    Json toJson(const Grade& grade)
    {
        const std::vector<Row>& rows = grade.rows;
        Json json = { { "complete", grade.isComplete },
            { "sandbox", grade.notSandboxed.empty() ? "bubblewrap" : "none: " + grade.notSandboxed } };
        json.update(toJson(totalOf(rows)));
        json["features"] = Json::object();
        for (const std::string& feature : featuresOf(rows))
            json["features"][feature] = toJson(totalOf(rows, feature));
        json["checks"] = Json::array();
        for (const Row& row : rows)
            json["checks"].push_back(toJson(row));
        json["observations"] = Json::object();
        for (const auto& [feature, drawn, expected] : grade.observations)
            json["observations"][feature] = { { "drawn", drawn }, { "expected", expected } };
        return json;
    }

}

void writeJson(const std::filesystem::path& path, const Grade& grade)
{
    writeWhole(path, toJson(grade).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}
