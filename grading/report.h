#pragma once
#include "grading/row.h"
#include <filesystem>
#include <string>
#include <vector>

namespace grading {

struct Score {
    double score = 0.0;
    double maxScore = 0.0;
};

// Of all rows, or of one feature's.
[[nodiscard]] Score totalOf(const std::vector<Row>& rows, const std::string& feature = "");

// A table for the terminal: a line a check, what went wrong below it, the features' points and the total.
void printTable(const std::vector<Row>& rows, bool withColor);

// {"score", "max_score", "features": {name: {"score", "max_score"}}, "checks": [{"name", "feature", "score",
// "max_score", "status", "message"}]}. The file appears whole or not at all. Throws files::Error.
void writeJson(const std::filesystem::path& path, const std::vector<Row>& rows);

}
