#include "graded.h"
#include "submission/paths.h"
#include <catch2/catch.hpp>
#include <cstdlib>
#include <sys/wait.h>

// Points for standing up to the cases of ./raywork stress.

// The row of a file.
static nlohmann::json rowOf(const Graded& graded, const std::string& file)
{
    for (const auto& check : graded.json.at("checks"))
        if (check.at("name") == "stress." + file)
            return check;
    FAIL("no row of " << file);
    return {};
}

TEST_CASE("The reference stands up to stress, and gets the points for it beside the 100", "[grading]")
{
    const auto seed = GENERATE(1, 2);
    const Graded graded = grade(root / "reference", "--stress-points 14 --seed " + std::to_string(seed));
    INFO(graded.printed);
    CHECK(graded.exitCode == 0);
    CHECK(graded.json.at("score") == 114);
    CHECK(graded.json.at("features").at("stress").at("max_score") == 14);
    CHECK(graded.lost("stress") == 0);
}

TEST_CASE("Stubs do not stand up to stress: no file is attempted", "[grading]")
{
    const Graded graded = grade(root / "student", "--stress-points 14");
    INFO(graded.printed);
    CHECK(graded.lost("stress") == 14);
    CHECK(graded.count("stress", "not attempted") == 7);
}

TEST_CASE("An offset that suits the scenes alone costs its own part, and the line shown repeats that", "[grading]")
{
    const auto folder = copyOfReference("recursive", [](const std::string& text) {
        return replaced(text, "point + originOffset(ray) * hitInfo.normal", "point + 1e-3f * hitInfo.normal");
    });
    const Graded graded = grade(folder, "--stress-points 14");
    INFO(graded.printed);
    CHECK(graded.lostElsewhere("stress") == 0);
    CHECK(graded.lost("stress") == 2);
    const auto row = rowOf(graded, "recursive");
    CHECK(row.at("score") == 0);
    CHECK(row.at("status") == "wrong");
    const std::string message = row.at("message"), program = "./raywork stress ";
    for (const std::string word : { "cases failed", "asked", "came", "expected" })
        CHECK_THAT(message, Catch::Contains(word));
    const std::size_t from = message.find(program) + program.size();
    const std::string again = message.substr(from, message.find('\n', from) - from);
    const std::string command = std::string(submission::buildDirectory) + "/grading/raywork-stress " + again;
    CHECK(WEXITSTATUS(std::system((command + " > /dev/null").c_str())) == 1);
}

TEST_CASE("A feature alone is graded without stress, and a pattern hides its rows", "[grading]")
{
    const Graded alone = grade(root / "reference", "--stress-points 14 --only texture");
    CHECK(alone.json.at("max_score") == 10);
    const Graded hidden = grade(root / "student", "--stress-points 0 --hide 'stress.*'");
    INFO(hidden.printed);
    CHECK(hidden.json.at("max_score") == 100);
    CHECK(hidden.count("stress", "hidden") == 7);
    CHECK(grade(root / "reference", "--only texture --hide 'stress.*'").exitCode == 2);
}
