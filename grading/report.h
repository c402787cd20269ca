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

// Of all rows, or of one feature's. Hidden checks count.
[[nodiscard]] Score totalOf(const std::vector<Row>& rows, const std::string& feature = "");

// The features that have rows, in the order of these.
[[nodiscard]] std::vector<std::string> featuresOf(const std::vector<Row>& rows);

// The rows of one feature, in their order.
[[nodiscard]] std::vector<Row> rowsOf(const std::vector<Row>& rows, const std::string& feature);

// What went wrong and what usually causes it, for those who read text; empty where nothing did.
[[nodiscard]] std::string explanationOf(const Row& row);

// The same words, every byte of them UTF-8: a student's exception may say anything.
[[nodiscard]] std::string toUtf8(const std::string& text);

// The writers. Of a hidden check all but Gradescope's tell the name alone. Files appear whole or not at all; what they
// throw is said at writeWhole.

// A table for the terminal: a line a check, what went wrong below it, the features' points and the total.
void printTable(const Grade& grade, bool withColor);

// {"complete", "sandbox", "score", "max_score", "features": {name: {"score", "max_score"}}, "checks": [{"name",
// "feature", "score", "max_score", "status", "message"}], "observations": {feature: {"drawn", "expected"}}}; a hidden
// check is {"name", "feature", "hidden": true}. sandbox is "bubblewrap", or "none: " and why.
void writeJson(const std::filesystem::path& path, const Grade& grade);

// JUnit's XML: a suite a feature, a case a check, a failure whatever keeps it from passing. A check that was not
// attempted is a failure too, since servers show a run of skipped cases as a good one.
void writeJunit(const std::filesystem::path& path, const Grade& grade);

// Gradescope's results.json, as its "Autograder Specifications" describe it. Hidden checks keep their points, by which
// the teacher sees them there, and get visibility "hidden", by which the student does not.
void writeGradescope(const std::filesystem::path& path, const Grade& grade);

// A page that needs nothing but itself: what the student lost, why, and the pictures to compare.
void writeHtml(const std::filesystem::path& path, const Grade& grade);

}
