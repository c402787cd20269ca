#pragma once
#include "grading/validate/bank.h"
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

// What ./raywork stress said of a folder.
struct Stressed {
    int exitCode = 0;
    std::string printed; // stdout and stderr
    nlohmann::json json; // null if none was written

    [[nodiscard]] int failed(const std::string& feature) const { return json.at("features").at(feature).at("failed"); }
};

// Asks a folder's functions, by the program.
[[nodiscard]] Stressed stress(const std::filesystem::path& folder, const std::string& options);

// The reference with a file's text changed. The next one takes its place.
[[nodiscard]] std::filesystem::path changedReference(const std::string& file, const std::string& text);

// A mistake that the grader's bank knows by this name; fails the test if there is none.
[[nodiscard]] const grading::Solution& mistakeNamed(const std::string& file, const std::string& name);
