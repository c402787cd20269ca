#include "stressed.h"
#include "../files/temporary_folder.h"
#include "grading/validate/folder.h"
#include "submission/paths.h"
#include <algorithm>
#include <catch2/catch.hpp>
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

fs::path workFolder()
{
    static const files_test::TemporaryFolder folder;
    return folder / "";
}

}

Stressed stress(const fs::path& folder, const std::string& options)
{
    const fs::path json = workFolder() / "stress.json", printed = workFolder() / "printed.txt";
    fs::remove(json);
    const std::string command = std::string(submission::buildDirectory) + "/grading/raywork-stress '" + folder.string()
        + "' --json '" + json.string() + "' " + options + " > '" + printed.string() + "' 2>&1";
    Stressed stressed;
    stressed.exitCode = WEXITSTATUS(std::system(command.c_str()));
    stressed.printed = read(printed);
    if (fs::exists(json))
        stressed.json = nlohmann::json::parse(read(json));
    return stressed;
}

fs::path changedReference(const std::string& file, const std::string& text)
{
    const fs::path folder = workFolder() / "submission";
    fs::remove_all(folder);
    grading::writeChangedReference(folder, file, text);
    return folder;
}

const grading::Solution& mistakeNamed(const std::string& file, const std::string& name)
{
    static const grading::Bank bank = grading::loadBank(fs::path(submission::sourceDirectory) / "tests" / "grading");
    const auto found = std::ranges::find_if(
        bank.wrong, [&](const grading::Solution& wrong) { return wrong.file == file && wrong.name == name; });
    INFO(file << ": " << name);
    REQUIRE(found != bank.wrong.end());
    return *found;
}
