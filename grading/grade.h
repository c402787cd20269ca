#pragma once
#include "grading/expected.h"
#include "grading/row.h"
#include "grading/secret.h"
#include "grading/times.h"
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

namespace grading {

struct Assignment {
    std::filesystem::path submission; // folder
    std::shared_ptr<ExpectedAnswers> expected;
    std::string onlyFeature; // empty: all
    Secret secret { 1 }; // what all random inputs follow from
    std::filesystem::path knownRows = {}; // folder of what need not be asked again; empty: nothing is known
    std::filesystem::path knownDrawings = {}; // likewise, of what was drawn
    bool wantsObservations = false; // otherwise nobody looks at what is drawn
};

struct Outcome {
    std::vector<Row> rows; // in the order of the checks
    std::vector<Observation> observations; // of those features that answer
    Times times;
};

// Builds the submission and runs all checks, features side by side. Calls onRow from any thread after each check.
// Throws files::Error when the submission is no folder, and std::runtime_error when the grader itself fails.
[[nodiscard]] Outcome grade(const Assignment& assignment, const std::function<void(const Row&)>& onRow = {});

}
