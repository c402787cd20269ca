#include "graded.h"
#include "grading/feature.h"
#include "submission/paths.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>

namespace fs = std::filesystem;

TEST_CASE("The reference gets all points", "[grading]")
{
    const Graded graded = grade(root / "reference");
    INFO(graded.printed);
    CHECK(graded.exitCode == 0);
    CHECK(graded.json.at("score") == 100);
    CHECK(graded.json.at("max_score") == 100);
    for (const grading::Feature& feature : grading::gradedFeatures)
        CHECK(graded.json.at("features").at(feature.name).at("max_score") == feature.points);
    for (const auto& check : graded.json.at("checks")) {
        CHECK(check.at("status") == "passed");
        CHECK(check.at("message") == "");
        CHECK(check.at("score") == check.at("max_score"));
        CHECK(check.at("name").get<std::string>().starts_with(check.at("feature").get<std::string>() + "."));
    }
}

TEST_CASE("The reference gets all points for other random inputs", "[grading]")
{
    const auto seed = GENERATE(2, 12345);
    const Graded graded = grade(root / "reference", "--seed " + std::to_string(seed));
    INFO(graded.printed);
    CHECK(graded.json.at("score") == 100);
}

// None of the checks has points or is attempted; its message contains that.
static void checkNotAttempted(const Graded& graded, const std::string& message)
{
    INFO(graded.printed);
    CHECK(graded.exitCode == 0);
    CHECK(graded.json.at("score") == 0);
    CHECK(graded.json.at("max_score") == 100);
    for (const auto& check : graded.json.at("checks")) {
        CHECK(check.at("status") == "not attempted");
        CHECK_THAT(check.at("message").get<std::string>(), Catch::Contains(message));
    }
}

TEST_CASE("The stubs get no points, and every row says that they are not attempted", "[grading]")
{
    const fs::path folder = workFolder() / "stubs";
    fs::create_directory(folder);
    for (const auto& file : fs::directory_iterator(root / "student"))
        if (file.path().extension() == ".cpp")
            std::ofstream(folder / file.path().filename()) << "// mine\n" << std::ifstream(file.path()).rdbuf();
    checkNotAttempted(grade(folder), "not written yet: ");
}

TEST_CASE("What is as it was handed out is not attempted, and neither compiled nor asked", "[grading]")
{
    const fs::path times = workFolder() / "times.json";
    checkNotAttempted(
        grade(root / "student", "--fresh --times '" + times.string() + "'"), ".cpp: as it was handed out");
    const nlohmann::json files = nlohmann::json::parse(std::ifstream(times)).at("files");
    REQUIRE(files.size() == 7);
    for (const auto& [name, seconds] : files.items()) {
        CHECK(seconds.at("compiling") == 0.0);
        CHECK(seconds.at("linking") == 0.0);
    }
}

TEST_CASE("An empty folder is graded like the stubs", "[grading]")
{
    const fs::path empty = workFolder() / "empty";
    fs::create_directory(empty);
    checkNotAttempted(grade(empty), ".cpp: no such file");
}

TEST_CASE("One feature can be graded alone", "[grading]")
{
    const Graded graded = grade(root / "reference", "--only texture");
    INFO(graded.printed);
    CHECK(graded.json.at("max_score") == 10);
    CHECK(graded.json.at("features").size() == 1);
}

TEST_CASE("Bad input ends with one line and exit code 2", "[grading]")
{
    SECTION("no folder")
    {
        const Graded graded = grade("/no/such/folder");
        CHECK(graded.exitCode == 2);
        CHECK(graded.printed == "/no/such/folder: found no folder, expected one with the files of a submission\n");
    }
    SECTION("no feature")
    {
        CHECK(grade(root / "reference", "--only colour").exitCode == 2);
    }
}

TEST_CASE("Recorded answers give the grade that the reference's worker gives, and need no worker", "[grading]")
{
    const std::string golden = (workFolder() / "golden").string();
    const std::string only = "--only texture"; // has pictures with two valid answers
    const fs::path folder = copyOfReference("texture", [](const std::string& text) { return text; });
    const Graded live = grade(folder, only);

    const std::string record
        = std::string(submission::buildDirectory) + "/grading/raywork-grade " + only + " --record '" + golden + "'";
    REQUIRE(std::system(record.c_str()) == 0);
    const std::string fromFile = " --reference-worker /nowhere --golden '" + golden + "'";
    const Graded recorded = grade(folder, only + fromFile);
    const Graded otherFeature = grade(folder, "--only reflection" + fromFile);

    INFO(recorded.printed);
    CHECK(recorded.exitCode == 0);
    CHECK(recorded.json.at("checks") == live.json.at("checks"));
    CHECK(otherFeature.exitCode == 75);
    CHECK(std::ranges::count(otherFeature.printed, '\n') == 1);
    CHECK_THAT(otherFeature.printed, Catch::Contains("golden: found no answer of render.replicates"));
}
