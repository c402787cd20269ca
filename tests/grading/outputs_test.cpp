#include "files/error.h"
#include "files/temporary_folder.h"
#include "files/text.h"
#include "grading/outputs.h"
#include "grading/report.h"
#include "grading/write_whole.h"
#include "submission/paths.h"
#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sys/wait.h>

// What a grade is written to.

namespace {

namespace fs = std::filesystem;
using files_test::TemporaryFolder;
using grading::Row;
using grading::Status;
using nlohmann::json;

// What no format may stumble over: markup, the end of a script, quotes, control characters, no UTF-8, no character.
const std::string nasty = "a <b> & \"c\" ]]> </script> \x01\x1b[31m \xff\xfe \xEF\xBF\xBF \xc3\xa9";

std::vector<Row> someRows()
{
    const auto pictures = std::make_shared<grading::PicturePair>(
        grading::PicturePair { { 1, 1 }, { glm::vec3(0.25f) }, { glm::vec3(0.5f) } });
    return {
        { "texture.nearest.inside", "texture", 2.0, 2.0, Status::Passed, "" },
        { "texture.nearest.border", "texture", 0.0, 1.0, Status::Wrong, nasty, pictures, "secret cause" },
        { "light.segment.mean", "light", 0.0, 4.0, Status::NotAttempted, "secret message" },
        { "light.binary.self", "light", 0.0, 1.0, Status::Crashed, "killed by signal 11" },
    };
}

json readJson(const fs::path& path)
{
    return json::parse(files::readText(path));
}

}

TEST_CASE("JUnit has a suite a feature, a case a check, and a failure for each that did not pass", "[grading]")
{
    const TemporaryFolder folder;
    grading::writeJunit(folder / "junit.xml", { someRows() });
    pugi::xml_document document;
    REQUIRE(document.load_file((folder / "junit.xml").c_str()));
    const pugi::xml_node suites = document.child("testsuites");
    CHECK(suites.attribute("tests").as_int() == 4);
    CHECK(suites.attribute("failures").as_int() == 3);
    const pugi::xml_node texture = suites.find_child_by_attribute("name", "texture");
    CHECK(texture.attribute("failures").as_int() == 1);
    CHECK_FALSE(texture.first_child().child("failure"));
    const pugi::xml_node failure = texture.last_child().child("failure");
    CHECK(failure.attribute("type").value() == std::string("wrong"));
    CHECK(std::string(failure.text().get())
        == "a <b> & \"c\" ]]> </script> ??[31m \xEF\xBF\xBD\xEF\xBF\xBD ? \xc3\xa9 (usually: secret cause)");
    const pugi::xml_node light = suites.find_child_by_attribute("name", "light");
    CHECK(light.first_child().child("failure").attribute("type").value() == std::string("not attempted"));
}

TEST_CASE("Gradescope gets the score, and of each test what its specification names", "[grading]")
{
    const TemporaryFolder folder;
    grading::writeGradescope(folder / "results.json", { grading::hide(someRows(), { "light.segment.*" }), "", 12.5 });
    const json results = readJson(folder / "results.json");
    CHECK(results.at("score") == 2.0);
    CHECK(results.at("execution_time") == 12.5);
    CHECK(results.at("visibility") == "visible");
    CHECK(results.at("extra_data").at("max_score") == 8.0);
    const json& tests = results.at("tests");
    REQUIRE(tests.size() == 4);
    double sum = 0.0;
    for (const json& test : tests) {
        sum += test.at("score").get<double>();
        CHECK(test.at("output_format") == "text");
        CHECK((test.at("status") == "passed") == (test.at("score") == test.at("max_score")));
    }
    CHECK(sum == results.at("score"));
    CHECK(tests[0].at("number") == "1.1");
    CHECK(tests[1].at("number") == "1.2");
    CHECK(tests[1].at("output").get<std::string>().starts_with("wrong: a <b>"));
    CHECK(tests[1].at("tags") == json::array({ "texture" }));
    CHECK(tests[2].at("visibility") == "hidden");
    CHECK(tests[2].at("output") == "");
    CHECK(tests[3].at("visibility") == "visible");
}

TEST_CASE("The JSON says whether the grade is complete", "[grading]")
{
    const TemporaryFolder folder;
    const bool complete = GENERATE(false, true);
    grading::writeJson(folder / "grade.json", { someRows(), "", 0.0, complete });
    CHECK(readJson(folder / "grade.json").at("complete") == complete);
}

TEST_CASE("Of a hidden check no file tells more than the name, but its points count", "[grading]")
{
    const TemporaryFolder folder;
    grading::Outputs outputs { folder / "json", folder / "junit", folder / "gradescope", folder / "html",
        { "texture.*.border", "light.segment.*" } };
    const std::vector<Row> rows = grading::hide(someRows(), outputs.hidden);
    CHECK((rows[1].message + rows[1].usualCause + rows[2].message).empty()); // what is not there, no writer can tell
    CHECK_FALSE(rows[1].pictures);
    grading::writeOutputs(outputs, { rows, "somebody", 1.0 });
    for (const char* const file : { "json", "junit", "gradescope", "html" }) {
        INFO(file);
        const std::string text = files::readText(folder / file);
        CHECK_THAT(text, Catch::Contains("light.segment.mean") && !Catch::Contains("secret"));
        CHECK_THAT(text, !Catch::Contains("not attempted\",\"score") && !Catch::Contains("\"pictures\":"));
    }
    const json graded = readJson(folder / "json");
    CHECK(graded.at("checks")[2]
        == json { { "name", "light.segment.mean" }, { "feature", "light" }, { "hidden", true } });
    CHECK(graded.at("max_score") == 8.0);
    CHECK(graded.at("features").at("light").at("max_score") == 5.0);
    pugi::xml_document junit;
    REQUIRE(junit.load_file((folder / "junit").c_str()));
    CHECK(junit.child("testsuites").attribute("failures").as_int() == 1); // a sum would tell
    CHECK(grading::totalOf(rows).maxScore == 8.0);
}

TEST_CASE("What was drawn is in the JSON and in the page, not in what gives points", "[grading]")
{
    const TemporaryFolder folder;
    const grading::Outputs outputs { folder / "json", folder / "junit", folder / "gradescope", folder / "html", {} };
    grading::Grade graded { someRows(), "somebody" };
    graded.observations = { { "texture", { "drawn </script>", nasty }, { "drawn by the solution" } } };
    grading::writeOutputs(outputs, graded);
    const json observations = readJson(folder / "json").at("observations");
    CHECK(observations.size() == 1);
    CHECK(observations.at("texture").at("drawn").at(0) == "drawn </script>");
    CHECK(observations.at("texture").at("expected") == json { "drawn by the solution" });
    CHECK_THAT(
        files::readText(folder / "html"), Catch::Contains("drawn by the solution") && !Catch::Contains("drawn </"));
    for (const char* const file : { "junit", "gradescope" })
        CHECK_THAT(files::readText(folder / file), !Catch::Contains("drawn"));
    CHECK(grading::hide(graded.observations, grading::hide(someRows(), { "texture.*.border" })).empty());
    CHECK(grading::hide(graded.observations, grading::hide(someRows(), { "light.*" })).size() == 1);
}

TEST_CASE("A pattern that hides nothing is an error, since it may be a typing mistake", "[grading]")
{
    CHECK_NOTHROW(grading::expectPatternsMatch({ "texture.*", "*.picture.*" }));
    CHECK_THROWS_AS(grading::expectPatternsMatch({ "texture.*", "textur.*" }), files::Error);
}

TEST_CASE("What a student's code says cannot end the page's script", "[grading]")
{
    const TemporaryFolder folder;
    grading::writeHtml(folder / "page.html", { someRows(), "</script>" });
    const std::string text = files::readText(folder / "page.html");
    const std::string start = "id=\"data\">";
    const std::size_t from = text.find(start) + start.size();
    const json data = json::parse(text.substr(from, text.find("</script", from) - from));
    CHECK(data.at("submission") == "</script>");
    CHECK_THAT(data.at("features")[0].at("checks")[1].at("message").get<std::string>(), Catch::Contains("</script>"));
}

TEST_CASE("A picture with another number of pixels than its size says is left out of the page", "[grading]")
{
    const TemporaryFolder folder;
    std::vector<Row> rows = someRows();
    const auto size = GENERATE(glm::ivec2(2, 1), glm::ivec2(0, 1), glm::ivec2(-1, -1), glm::ivec2(65536, 65536));
    rows[1].pictures = std::make_shared<grading::PicturePair>(
        grading::PicturePair { size, { glm::vec3(0.25f) }, { glm::vec3(0.5f) } });
    grading::writeHtml(folder / "page.html", { rows, "somebody" });
    CHECK_THAT(files::readText(folder / "page.html"), !Catch::Contains("\"pictures\":"));
}

TEST_CASE("A file that cannot be written is an error and leaves nothing", "[grading]")
{
    const TemporaryFolder folder;
    CHECK_THROWS_AS(grading::writeWhole(folder / "no/such/folder", "text"), files::Error);
    fs::create_directories(folder / "taken");
    CHECK_THROWS_AS(grading::writeWhole(folder / "taken", "text"), std::system_error);
    CHECK_FALSE(fs::exists(folder / "taken.unfinished"));
}

TEST_CASE("A disk that is full is an error, and the old file stays", "[grading]")
{
    const TemporaryFolder folder;
    folder.write("grade.json", "old");
    // A limit on the size of files stands in for the disk.
    const std::string command = "ulimit -f 1; exec '" + fs::canonical("/proc/self/exe").string() + "' '[.full-disk]'";
    setenv("RAYWORK_FULL_DISK", (folder / "grade.json").c_str(), 1);
    CHECK(std::system(command.c_str()) == 0);
    CHECK(files::readText(folder / "grade.json") == "old");
    CHECK_FALSE(fs::exists(folder / "grade.json.unfinished"));
}

TEST_CASE("Writing beyond the limit throws", "[.full-disk]")
{
    std::signal(SIGXFSZ, SIG_IGN);
    CHECK_THROWS_AS(
        grading::writeWhole(std::getenv("RAYWORK_FULL_DISK"), std::string(1 << 20, 'x')), std::system_error);
}

namespace {

// Gradescope's folders, with a launcher that does what it says.
struct Autograder {
    explicit Autograder(const std::string& launcher)
    {
        fs::permissions(folder.write("source/raywork", "#!/bin/sh\n" + launcher + "\n"), fs::perms::owner_all);
        fs::create_directories(folder / "submission");
    }

    int run() const
    {
        const std::string command = "RAYWORK_AUTOGRADER='" + (folder / "").string() + "' '"
            + std::string(submission::sourceDirectory) + "/grading/gradescope/run_autograder' > /dev/null 2>&1";
        return WEXITSTATUS(std::system(command.c_str()));
    }

    TemporaryFolder folder;
};

}

TEST_CASE("run_autograder grades the submission into results.json", "[grading]")
{
    const Autograder autograder(
        "shift; exec '" + std::string(submission::buildDirectory) + "/grading/raywork-grade' --only texture \"$@\"");
    fs::copy(fs::path(submission::sourceDirectory) / "reference" / "texture.cpp", autograder.folder / "submission");
    CHECK(autograder.run() == 0);
    const json results = readJson(autograder.folder / "results/results.json");
    CHECK(results.at("score") == 10.0);
    CHECK_FALSE(results.at("tests").empty());
}

TEST_CASE("When the grader fails, run_autograder leaves nothing that looks like a grade", "[grading]")
{
    const auto code = GENERATE(2, 69, 75);
    const Autograder autograder("exit " + std::to_string(code));
    autograder.folder.write("results/results.json", R"({"score": 100})"); // of an earlier run
    CHECK(autograder.run() == code);
    const json results = readJson(autograder.folder / "results/results.json");
    CHECK_FALSE(results.contains("score"));
    CHECK(results.at("tests").empty());
    CHECK_THAT(results.at("output").get<std::string>(), Catch::Contains("The grader failed"));
}
