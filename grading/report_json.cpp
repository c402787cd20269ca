#include "files/error.h"
#include "grading/feature.h"
#include "grading/report.h"
#include <fstream>
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
        return { { "name", row.name }, { "feature", row.feature }, { "score", row.score },
            { "max_score", row.maxScore }, { "status", std::string(toText(row.status)) }, { "message", row.message } };
    }

    Json toJson(const std::vector<Row>& rows)
    {
        Json json = toJson(totalOf(rows));
        json["features"] = Json::object();
        for (const Feature& feature : gradedFeatures)
            if (const Score total = totalOf(rows, feature.name); total.maxScore > 0.0)
                json["features"][feature.name] = toJson(total);
        json["checks"] = Json::array();
        for (const Row& row : rows)
            json["checks"].push_back(toJson(row));
        return json;
    }

}

void writeJson(const std::filesystem::path& path, const std::vector<Row>& rows)
{
    // A student's exception may say anything: what is no UTF-8 is replaced.
    const std::string text = toJson(rows).dump(2, ' ', false, Json::error_handler_t::replace);
    std::filesystem::path unfinished = path;
    unfinished += ".unfinished";
    std::ofstream file(unfinished);
    file << text << '\n';
    file.close();
    std::error_code failed;
    if (file)
        std::filesystem::rename(unfinished, path, failed);
    if (!file || failed)
        throw files::Error(path, "cannot be written");
}

}
