#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace report_test {

// The report of "reference" or "student" that was made before the tests.
[[nodiscard]] std::filesystem::path madeReport(const std::string& submission);

// A figure of it: what its JSON says.
[[nodiscard]] nlohmann::json figure(const std::string& name, const std::string& submission = "reference");

// All of them.
[[nodiscard]] std::vector<nlohmann::json> figures(const std::string& submission);

// Runs a shell's command and returns what it printed; fails the test if it fails.
std::string run(const std::string& command);

}
