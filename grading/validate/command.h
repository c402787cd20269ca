#pragma once
#include "grading/grade.h"
#include "grading/validate/on_progress.h"
#include <optional>
#include <string>
#include <vector>

namespace grading {

// ./raywork grade --validate and --mutants
struct ValidationOptions {
    bool validate = false;
    uint64_t seed = 1; // of the wrong solutions, and the first of the accepted ones
    std::size_t gradings = 1000; // of accepted solutions, in all
    std::size_t sample = 0; // of the wrong solutions; 0: all
    bool mutate = false;
    std::vector<std::string> mutatedFiles; // without .cpp; none: all
    std::filesystem::path bank; // folder with wrong/, accepted/ and survivors.toml

    [[nodiscard]] bool wanted() const { return validate || mutate; }
};

// Validates the grader, prints what came out, and returns whether it made no mistake. Throws files::Error for a bad
// bank, otherwise what grade() does.
[[nodiscard]] bool runValidation(
    const ValidationOptions& options, const std::shared_ptr<ExpectedAnswers>& expected, const OnProgress& onProgress);

}
