#include "grading/validate/folder.h"
#include "stressed.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <set>

// What ./raywork stress says, and that nothing a submission does keeps it from saying the rest.

namespace {

// reference/interpolate.cpp with a statement at the beginning of interpolateTexCoord.
std::filesystem::path withStatement(const std::string& statement)
{
    std::ifstream file(grading::referenceSource("interpolate"));
    std::string text { std::istreambuf_iterator<char>(file), {} };
    const std::string body = "    return bc.x * t0 + bc.y * t1 + bc.z * t2;";
    REQUIRE(text.find(body) != std::string::npos);
    text.insert(text.find(body), statement);
    return changedReference("interpolate", text);
}

// The words for the failures of a name.
std::set<std::string> wordsFor(const Stressed& stressed, const std::string& name)
{
    std::set<std::string> words;
    for (const auto& failure : stressed.json.at("failures"))
        if (failure.at("name") == name)
            words.insert(failure.at("status").get<std::string>());
    return words;
}

}

TEST_CASE("The reference and the framework pass all", "[stress]")
{
    const Stressed stressed = stress("reference", "--cases 100000 --seed 3");
    INFO(stressed.printed);
    CHECK(stressed.exitCode == 0);
    CHECK(stressed.json.at("failed") == 0);
    CHECK(stressed.json.at("cases") > 100000);
    CHECK(stressed.json.at("failures").empty());
    for (const std::string feature : { "triangle", "box", "bvh", "recursive", "interpolate" })
        CHECK(stressed.json.at("features").at(feature).at("cases") > 0);
}

TEST_CASE("A failure is reproduced by the line that it prints", "[stress]")
{
    const auto folder = changedReference("interpolate", mistakeNamed("interpolate", "normal not unit").text);
    const Stressed stressed = stress(folder, "--only interpolate.normal --cases 1000 --seed 7");
    INFO(stressed.printed);
    REQUIRE(stressed.json.at("failures").size() > 1);
    const auto failure = stressed.json.at("failures").at(1);
    const std::string again = failure.at("again"), command = "./raywork stress " + folder.string();
    REQUIRE(again.starts_with(command));

    const Stressed repeated = stress(folder, again.substr(command.size()));
    CHECK(repeated.exitCode == 1);
    CHECK(repeated.json.at("cases") == 1);
    for (const std::string what : { "name", "case", "asked", "came", "expected" })
        CHECK(repeated.json.at("failures").at(0).at(what) == failure.at(what));
}

TEST_CASE("A case that crashes, throws or hangs fails by that word, and the others are judged", "[stress]")
{
    struct End {
        std::string statement, word;
    };
    const auto [statement, word] = GENERATE(values<End>({ { "if (t0.x == -1000.0f) __builtin_trap();\n", "crashed" },
        { "if (t0.x == -1000.0f) throw std::exception();\n", "threw" },
        { "for (volatile bool forever = t0.x == -1000.0f; forever;) { }\n", "timed out" } }));
    const Stressed stressed = stress(withStatement(statement), "--only interpolate.tex_coord --cases 1000");
    INFO(stressed.printed);
    CHECK(stressed.exitCode == 1);
    CHECK(stressed.json.at("failed") == 1); // of the special ones, that which repeats
    CHECK(wordsFor(stressed, "interpolate.tex_coord.special") == std::set<std::string> { word });
    CHECK(stressed.json.at("failures").at(0).at("called") == "repeating");
}

TEST_CASE("What is not written yet is not attempted rather than wrong", "[stress]")
{
    const Stressed stressed = stress("student", "--only interpolate --cases 1000");
    INFO(stressed.printed);
    CHECK(stressed.exitCode == 1);
    CHECK(stressed.json.at("failed") == 0);
    CHECK(stressed.json.at("not_attempted") == stressed.json.at("cases"));
}

TEST_CASE("Bad input is a line and exit code 2", "[stress]")
{
    const auto options = GENERATE(values<std::string>({ "--only nothing", "--case 3", "--only interpolate --case 3",
        "--only interpolate.normal.special --case 99", "--cases 0", "--seed x" }));
    const Stressed stressed = stress("reference", options);
    INFO(stressed.printed);
    CHECK(stressed.exitCode == 2);
    CHECK(std::ranges::count(stressed.printed, '\n') <= 2); // the parser adds one on --help
    CHECK(stress("no such folder", "").exitCode == 2);
}
