#pragma once
#include "grading/outputs.h"
#include "grading/validate/command.h"
#include <cstdint>
#include <optional>
#include <string>

namespace grading {

// What was asked of ./raywork grade.
struct Options {
    std::string submission; // folder
    std::string onlyFeature; // empty: all
    uint64_t seed = 1;
    std::string secretFile; // empty: inputs follow from the seed
    std::string sandbox = "auto"; // or "required" or "off"
    std::string referenceWorker; // program
    std::string golden; // file; empty: the reference's worker answers
    std::string times; // file to write to; empty: nowhere
    std::string record; // file to write the reference's answers to; empty: grade
    std::optional<double> stressPoints; // none: no stress
    bool isFresh = false;
    bool isWatching = false;
    Outputs outputs;
    ValidationOptions validation;
};

// Reads a command line. What it answers by itself (help, or a complaint about bad input) is printed; then the exit code
// comes back, and 0 means that all has been said.
[[nodiscard]] std::optional<int> parse(int argc, char** argv, Options& options);

}
