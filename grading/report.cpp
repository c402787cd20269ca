#include "grading/report.h"
#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>

namespace grading {

Score totalOf(const std::vector<Row>& rows, const std::string& feature)
{
    Score total;
    for (const Row& row : rows) {
        if (!feature.empty() && row.feature != feature)
            continue;
        total.score += row.score;
        total.maxScore += row.maxScore;
    }
    return total;
}

std::vector<std::string> featuresOf(const std::vector<Row>& rows)
{
    std::vector<std::string> features;
    for (const Row& row : rows)
        if (std::ranges::find(features, row.feature) == features.end())
            features.push_back(row.feature);
    return features;
}

std::vector<Row> rowsOf(const std::vector<Row>& rows, const std::string& feature)
{
    std::vector<Row> ofFeature;
    std::ranges::copy_if(rows, std::back_inserter(ofFeature), [&](const Row& row) { return row.feature == feature; });
    return ofFeature;
}

std::string explanationOf(const Row& row)
{
    return row.usualCause.empty() ? row.message : fmt::format("{} (usually: {})", row.message, row.usualCause);
}

std::string toUtf8(const std::string& text)
{
    using nlohmann::json; // its writer knows the rules of UTF-8, and replaces what breaks them
    return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace)).get<std::string>();
}

}
