#pragma once
#include "grading/expected.h"
#include "grading/kept_messages.h"
#include "grading/observation.h"
#include <filesystem>
#include <optional>

namespace grading {

// A worker with a submission's file for one feature.
struct Observed {
    std::string feature;
    std::string file; // of the submission, without .cpp
    std::filesystem::path program;
    std::string key; // of what was drawn before; changes with the program, the scenes and the grader
};

// Follows one ray in it and in the solution, and tells what both drew. A worker that fails gives an observation that
// says so, and takes two seconds at most; this throws nothing. None for multisampling, whose file no single ray meets.
[[nodiscard]] std::optional<Observation> observe(
    const Observed& observed, ExpectedAnswers& expected, const KeptMessages& known);

}
