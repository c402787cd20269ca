// Submissions that are not finished, or fail.
#include "files/temporary_folder.h"
#include "files/text.h"
#include "report/made.h"
#include "submission/paths.h"
#include <catch2/catch.hpp>
#include <map>

namespace fs = std::filesystem;

TEST_CASE("Figures of stubs say what is not written yet", "[report]")
{
    REQUIRE_FALSE(report_test::figures("student").empty());
    for (const nlohmann::json& figure : report_test::figures("student")) {
        INFO(figure.dump());
        if (figure.at("name") == "shading.lobes") // of models that are provided
            continue;
        CHECK(figure.at("state") == "not written");
        CHECK_FALSE(figure.at("message").get<std::string>().empty());
    }
}

TEST_CASE("The reference's figures are all drawn, and all that they claim holds", "[report]")
{
    for (const nlohmann::json& figure : report_test::figures("reference")) {
        INFO(figure.at("name"));
        REQUIRE(figure.at("state") == "drawn");
        CHECK_FALSE(figure.at("panels").empty());
        for (const nlohmann::json& claim : figure.at("claims")) {
            INFO(claim.at("text"));
            CHECK(claim.at("holds").get<bool>());
        }
    }
}

TEST_CASE("Captions say what figures were made of, how long it took, and what they err or show", "[report]")
{
    for (const nlohmann::json& figure : report_test::figures("reference")) {
        if (figure.at("part") == "measurements")
            continue;
        std::map<std::string, std::string> facts;
        for (const nlohmann::json& fact : figure.at("facts"))
            facts.emplace(fact[0], fact[1]);
        INFO(figure.at("name"));
        CHECK(facts.contains("seconds"));
        if (facts.contains("scene") && facts["scene"].ends_with(".toml")) {
            CHECK(facts.contains("samples"));
            CHECK(facts.contains("seed"));
        }
        CHECK((!figure.at("claims").empty() || figure.at("facts").dump().find("RMSE") != std::string::npos));
    }
}

TEST_CASE("Code that crashes costs its own figures alone", "[report]")
{
    const files_test::TemporaryFolder folder;
    const fs::path submission = folder / "submission";
    fs::copy(fs::path(submission::sourceDirectory) / "reference", submission, fs::copy_options::recursive);
    std::string text = files::readText(submission / "shading.cpp");
    const std::string signature = "computeLinearGradientModelComparison(";
    text.insert(text.find('{', text.find(signature)) + 1, "std::abort();");
    files::writeText(submission / "shading.cpp", text + "#include <cstdlib>\n");
    const fs::path output = folder / "out";
    report_test::run(
        std::string(RAYWORK_PROGRAM) + " " + submission.string() + " -o " + output.string() + " --only shading");
    const auto stateOf = [&](const std::string& name) {
        return nlohmann::json::parse(files::readText(output / "figures" / (name + ".json"))).at("state");
    };
    CHECK(stateOf("shading.comparison") == "failed");
    CHECK(stateOf("shading.gradient") == "drawn");
    CHECK(stateOf("shading.lobes") == "drawn");
}

TEST_CASE("An unchanged figure is not drawn again", "[report]")
{
    const fs::path report = report_test::madeReport("reference");
    const fs::path picture = report / "figures" / "shading.lobes.1.png";
    const fs::file_time_type before = fs::last_write_time(picture);
    report_test::run(std::string(RAYWORK_PROGRAM) + " " + (report.parent_path() / "reference").string() + " -o "
        + report.string() + " --only shading.lobes");
    CHECK(fs::last_write_time(picture) == before);
}

TEST_CASE("An unknown figure is bad input, and the known ones are named", "[report]")
{
    const std::string printed
        = report_test::run("! " + std::string(RAYWORK_PROGRAM) + " reference --only texture.bilinaer");
    CHECK(printed.find("texture.bilinaer") != std::string::npos);
    CHECK(printed.find("shading.lobes") != std::string::npos);
}
