#include "files/error.h"
#include "graded.h"
#include "grading/validate/bank.h"
#include "grading/validate/folder.h"
#include "grading/validate/sample.h"
#include "submission/paths.h"
#include <catch2/catch.hpp>

// The bank of solutions that the grader is validated with.

namespace fs = std::filesystem;

namespace {

// A bank that holds wrong/texture.toml alone.
fs::path bankWith(const std::string& toml)
{
    const fs::path bank = workFolder() / "bank";
    fs::remove_all(bank);
    grading::writeSource(bank / "wrong" / "texture.toml", toml);
    return bank;
}

std::string errorOf(const fs::path& bank)
{
    try {
        (void)grading::loadBank(bank);
        return "";
    } catch (const files::Error& error) {
        return error.what();
    }
}

struct BadBank {
    std::string toml, message;
};

const std::string valid = "[[wrong]]\nname = 'a'\ncosts = ['texture']\n";

}

TEST_CASE("Every solution of the bank can be put together", "[validation]")
{
    const grading::Bank bank = grading::loadBank(fs::path(submission::sourceDirectory) / "tests" / "grading");
    CHECK(!bank.wrong.empty());
    CHECK(!bank.accepted.empty());
}

TEST_CASE("A solution of the bank is the reference with its replacements made all at once", "[validation]")
{
    const auto bank = grading::loadBank(bankWith(valid
        + "replace = [['const int i0', 'const int j0'],\n"
          "  ['const int j0', 'const int i0'], ['// In units', '']]\n"));
    REQUIRE(bank.wrong.size() == 1);
    CHECK(bank.accepted.empty());
    CHECK(bank.wrong[0].title() == "texture: a");
    CHECK(bank.wrong[0].costs == std::set<std::string> { "texture" });
    CHECK_THAT(bank.wrong[0].text,
        Catch::Contains("const int j0 = static_cast<int>(x)") && Catch::Contains("const int i0 = static_cast<int>(y)")
            && !Catch::Contains("// In units"));
}

TEST_CASE("A bad entry of the bank is told in one line with its place", "[validation]")
{
    const auto bad = GENERATE(values<BadBank>({
        { valid + "colour = 1\nreplace = [['0.0f', '1.0f']]", ":4: found the unknown key \"colour\"" },
        { valid + "replace = [\n['no such text', '']]", ":5: found \"no such text\" 0 times in reference/texture.cpp" },
        { valid + "replace = [\n['image.width', '']]", " times in reference/texture.cpp, expected it once" },
        { valid + "replace = [['', 'a']]", ":4: found \"\" 0 times" },
        { valid + "replace = [['a']]", ":4: found an array of 1, expected a pair of strings" },
        { valid + "replace = [[1, 2]]", ":4: found 1, expected a pair of strings" },
        { valid + "replace = [['float fx', ''], ['const float fx', '']]", ":4: found text that another pair replaces" },
        { valid + "replace = [['0.0f', '0.0f']]", ":4: found no change, expected one" },
        { valid, ":1: found neither replace and file, expected one of the two" },
        { valid + "replace = []\nfile = 'a.cpp'", ":1: found both replace and file, expected one of the two" },
        { valid + "file = 'a.cpp'", ":4: found \"a.cpp\", expected a file in " },
        { "[[wrong]]\nname = 'a'\nreplace = [['0.0f', '1.0f']]", ":1: found no costs" },
        { "[[wrong]]\ncosts = ['texture']\nreplace = [['0.0f', '1.0f']]", ":1: found no name" },
        { "[[wrong]]\nname = 'a'\ncosts = []\n", ":3: found an array of 0, expected at least one feature" },
        { "[[wrong]]\nname = 'a'\ncosts = ['colour']\n", ":3: found \"colour\", expected a feature" },
        { "[[wrong]]\nname = 'a'\ncosts = ['bvh']\nreplace = [['0.0f', '1.0f']]", ":1: found no why" },
        { "[[accepted]]\nname = 'a'\n", ":1: found the unknown key \"accepted\"" },
        { valid + "replace = [['0.0f', '1.0f']]\n" + valid + "replace = [['0.0f', '1.0f']]\n",
            ":5: found the name \"a\" twice" },
    }));
    const fs::path bank = bankWith(bad.toml);
    const std::string message = errorOf(bank);
    CHECK_THAT(message, Catch::StartsWith((bank / "wrong" / "texture.toml").string() + ":"));
    CHECK_THAT(message, Catch::Contains(bad.message) && !Catch::Contains("\n"));
}

TEST_CASE("A file of the bank that is named after no file of the reference is refused", "[validation]")
{
    const fs::path bank = bankWith("");
    grading::writeSource(bank / "wrong" / "textures.toml", "");
    CHECK(
        errorOf(bank) == (bank / "wrong" / "textures.toml").string() + ": found no file of that name in the reference");
}

TEST_CASE("A bank without solutions is refused", "[validation]")
{
    CHECK_THAT(errorOf(bankWith("")), Catch::Contains("found no solutions"));
}

TEST_CASE("A sample is spread evenly over the bank", "[validation]")
{
    grading::Bank bank;
    for (const char* name : { "0", "1", "2", "3", "4", "5", "6" }) {
        bank.wrong.push_back({ "bvh", name, { "bvh" }, "" });
        bank.accepted.push_back({ "bvh", name, {}, "" });
    }
    const grading::Bank sample = grading::sampleOf(bank, 3);
    REQUIRE(sample.wrong.size() == 3);
    CHECK(sample.wrong[0].name + sample.wrong[1].name + sample.wrong[2].name == "024");
    REQUIRE(sample.accepted.size() == 1);
    CHECK(sample.accepted[0].name == "0");
    CHECK(grading::sampleOf(bank, 100).wrong.size() == 7);
    CHECK(grading::sampleOf(bank, 100).accepted.size() == 7);
}
