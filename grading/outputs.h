#pragma once
#include "grading/row.h"
#include <string>
#include <vector>

namespace grading {

// Where a grade goes beside the terminal; empty: nowhere.
struct Outputs {
    std::string json, junit, gradescope, html; // files
    std::vector<std::string> hidden; // patterns of names, such as texture.*
};

// Throws files::Error for a pattern that matches no check and no other row: a typing mistake would show what is to be
// hidden.
void expectPatternsMatch(const std::vector<std::string>& patterns, const std::vector<std::string>& otherRows = {});

// The rows, those that match a pattern hidden, without what they would tell: message, cause and pictures.
[[nodiscard]] std::vector<Row> hide(std::vector<Row> rows, const std::vector<std::string>& patterns);

// What was drawn, without the features that have a hidden row: it would tell of that.
[[nodiscard]] std::vector<Observation> hide(std::vector<Observation> observations, const std::vector<Row>& rows);

// Writes all files that are asked for.
void writeOutputs(const Outputs& outputs, const Grade& grade);

}
