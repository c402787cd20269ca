#pragma once
#include "submission/paths.h"
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

// Helpers of the tests that grade whole folders.

// The checkout, and the build that the tests are part of.
inline const std::filesystem::path root { submission::sourceDirectory }, build { submission::buildDirectory };

// What ./raywork grade said of a folder.
struct Graded {
    int exitCode = 0;
    std::string printed; // stdout and stderr
    nlohmann::json json; // null if none was written

    [[nodiscard]] double lost(const std::string& feature) const;
    [[nodiscard]] double lostElsewhere(const std::string& feature) const;
    // How many checks of the feature have this status.
    [[nodiscard]] int count(const std::string& feature, const std::string& status) const;
};

// Grades a folder as a teacher would, by the program. environment: NAME=value and a blank.
[[nodiscard]] Graded grade(
    const std::filesystem::path& folder, const std::string& options = "", const std::string& environment = "");

// A folder that no other test writes to; gone when the program ends.
[[nodiscard]] std::filesystem::path workFolder();

// A copy of the reference, with one file changed. The next one takes its place.
[[nodiscard]] std::filesystem::path copyOfReference(
    const std::string& changedFile, const std::function<std::string(std::string)>& change);

// text with `from` replaced by `to`; fails the test if `from` does not stand there exactly once.
[[nodiscard]] std::string replaced(std::string text, const std::string& from, const std::string& to);

// Waits until it is so, and fails the test if that takes longer than anything should.
void waitUntil(const std::function<bool()>& isSo);
