#include "files/text.h"
#include "graded.h"
#include "grading/validate/folder.h"
#include "grading/validate/rate.h"
#include "submission/paths.h"
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <sys/wait.h>

// The grader graded, on small banks, by the program that a teacher calls.

namespace fs = std::filesystem;

namespace {

struct Validated {
    int exitCode = 0;
    std::string printed; // stdout and stderr
};

Validated run(const std::string& options)
{
    const fs::path printed = workFolder() / "validated.txt";
    const std::string command = std::string(submission::buildDirectory) + "/grading/raywork-grade " + options + " > '"
        + printed.string() + "' 2>&1";
    const int status = std::system(command.c_str());
    return { WEXITSTATUS(status), files::readText(printed) };
}

// A new bank in the folder of the build.
fs::path bankOf(const std::string& wrong, const std::string& accepted)
{
    const fs::path bank = workFolder() / "bank";
    fs::remove_all(bank);
    grading::writeSource(bank / "wrong" / "recursive.toml", wrong);
    grading::writeSource(bank / "accepted" / "texture.toml", accepted);
    return bank;
}

const std::string replacesColor = "replace = [['hitColor += hitInfo', 'hitColor = hitInfo']]\n";
const std::string movesOrigin = "replace = [['return 0x1p-15f *', 'return 0.2f *']]\n";

}

TEST_CASE("A grader without mistakes is told so", "[validation]")
{
    const fs::path bank = bankOf("[[wrong]]\nname = 'colour replaced'\ncosts = ['reflection']\n" + replacesColor,
        "[[accepted]]\nname = 'other name'\nreplace = [['const float fx =', 'const float weight ='],"
        "['texel(i1, j0), fx', 'texel(i1, j0), weight'], ['texel(i1, j1), fx', 'texel(i1, j1), weight']]\n");
    const Validated validated = run("--validate --gradings 2 --bank '" + bank.string() + "'");
    INFO(validated.printed);
    CHECK(validated.exitCode == 0);
    CHECK_THAT(validated.printed, Catch::Contains("0 of 1 wrong solutions"));
    CHECK_THAT(validated.printed, Catch::Contains("0 of 2 gradings of 1 right solutions"));
    CHECK_THAT(validated.printed, Catch::Contains("0 of 7 right features"));
}

TEST_CASE("Every kind of mistake of the grader is told by name", "[validation]")
{
    const fs::path bank = bankOf("[[wrong]]\nname = 'harmless'\ncosts = ['reflection']\n"
                                 "replace = [['drawRay(passthrough, hitColor);', '']]\n"
                                 "[[wrong]]\nname = 'both rays moved'\ncosts = ['reflection']\n"
            + movesOrigin,
        "[[accepted]]\nname = 'half a texel off'\nreplace = [['- 0.5f, image.width', ', image.width']]\n");
    const Validated validated = run("--validate --gradings 1 --seed 5 --bank '" + bank.string() + "'");
    INFO(validated.printed);
    CHECK(validated.exitCode == 1);
    CHECK_THAT(validated.printed, Catch::Contains("1 of 2 wrong solutions"));
    CHECK_THAT(validated.printed, Catch::Contains("  recursive: harmless (all points for reflection)\n"));
    CHECK_THAT(validated.printed, Catch::Contains("1 of 1 gradings of 1 right solutions"));
    CHECK_THAT(validated.printed, Catch::Contains("  texture: half a texel off, seed 5: texture.bilinear."));
    CHECK_THAT(validated.printed, Catch::Contains("1 of 14 right features")); // 8 - 1 of each wrong solution
    CHECK_THAT(validated.printed, Catch::Contains("  recursive: both rays moved, seed 5: transparency."));
}

TEST_CASE("A bad bank and a bad list of survivors end with one line and exit code 2", "[validation]")
{
    const fs::path bank = bankOf("[[wrong]]\nname = 'a'\ncosts = ['colour']\n", "");
    CHECK(run("--validate --bank '" + bank.string() + "'").exitCode == 2);

    const fs::path list = bank / "survivors.toml";
    grading::writeSource(list, "\n[[survivor]]\nfile = 'render'\nline_text = 'a'\nmutant_text = 'b'\nwhy = 'c'\n");
    const Validated validated = run("--mutants render --bank '" + bank.string() + "'");
    CHECK(validated.exitCode == 2);
    CHECK_THAT(
        validated.printed, Catch::StartsWith(list.string() + ":2: found no such mutant of reference/render.cpp"));
}

TEST_CASE("Nothing to grade, and an unknown file to change, end with exit code 2", "[validation]")
{
    CHECK(run("").exitCode == 2);
    CHECK(run("--mutants colour").exitCode == 2);
}

TEST_CASE("The bound of a rate is the one of Clopper and Pearson", "[validation]")
{
    for (const std::size_t total : { 1u, 10u, 1000u })
        CHECK(grading::upperBoundOfRate(0, total) == Approx(1.0 - std::pow(0.05, 1.0 / static_cast<double>(total))));
    CHECK(grading::upperBoundOfRate(1, 10) == Approx(0.39416).epsilon(1e-4)); // tables give so many digits
    CHECK(grading::upperBoundOfRate(9, 10) == Approx(std::pow(0.95, 0.1))); // 1 - p^10 = 0.05
    CHECK(grading::upperBoundOfRate(10, 10) == 1.0);
}
