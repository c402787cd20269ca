#include "graded.h"
#include "../files/temporary_folder.h"
#include "submission/features.h"
#include "submission/paths.h"
#include <catch2/catch.hpp>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sys/wait.h>

namespace fs = std::filesystem;

namespace {

std::string read(const fs::path& path)
{
    std::ifstream file(path);
    return { std::istreambuf_iterator<char>(file), {} };
}

}

fs::path workFolder()
{
    static const files_test::TemporaryFolder folder;
    return folder / "";
}

double Graded::lost(const std::string& feature) const
{
    const auto& score = json.at("features").at(feature);
    return score.at("max_score").get<double>() - score.at("score").get<double>();
}

double Graded::lostElsewhere(const std::string& feature) const
{
    return json.at("max_score").get<double>() - json.at("score").get<double>() - lost(feature);
}

int Graded::count(const std::string& feature, const std::string& status) const
{
    int count = 0;
    for (const auto& check : json.at("checks"))
        count += check.at("feature") == feature && check.value("status", "hidden") == status;
    return count;
}

Graded grade(const fs::path& folder, const std::string& options, const std::string& environment)
{
    const fs::path json = workFolder() / "grade.json";
    const fs::path printed = workFolder() / "printed.txt";
    fs::remove(json);
    const std::string command = environment + std::string(submission::buildDirectory) + "/grading/raywork-grade '"
        + folder.string() + "' --json '" + json.string() + "' " + options + " > '" + printed.string() + "' 2>&1";
    Graded graded;
    graded.exitCode = WEXITSTATUS(std::system(command.c_str()));
    graded.printed = read(printed);
    if (fs::exists(json))
        graded.json = nlohmann::json::parse(read(json));
    return graded;
}

fs::path copyOfReference(const std::string& changedFile, const std::function<std::string(std::string)>& change)
{
    const fs::path folder = workFolder() / "submission";
    fs::remove_all(folder);
    fs::create_directories(folder);
    for (const std::string& feature : submission::features) {
        const std::string text = read(fs::path(submission::sourceDirectory) / "reference" / (feature + ".cpp"));
        std::ofstream(folder / (feature + ".cpp")) << (feature == changedFile ? change(text) : text);
    }
    return folder;
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t at = text.find(from);
    INFO("to be replaced: " << from);
    REQUIRE(at != std::string::npos);
    REQUIRE(text.find(from, at + 1) == std::string::npos);
    return text.replace(at, from.size(), to);
}

void waitUntil(const std::function<bool()>& isSo)
{
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    while (!isSo())
        if (std::chrono::steady_clock::now() > end)
            FAIL("waited in vain");
}
