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

// It claims something, and all of that holds.
void checkClaims(const nlohmann::json& figure);

// All of them.
[[nodiscard]] std::vector<nlohmann::json> figures(const std::string& submission);

// What gnuplot drew a panel of the reference's figure from; panels count from 1.
[[nodiscard]] std::string scriptOf(const std::string& figure, int panel);

// The rows of a block of numbers in it.
[[nodiscard]] std::vector<std::vector<double>> plottedRows(
    const std::string& figure, int panel, const std::string& block);

// Runs a shell's command and returns what it printed; fails the test if it fails.
std::string run(const std::string& command);

}
