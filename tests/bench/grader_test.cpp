#include "../files/temporary_folder.h"
#include "bench/grader.h"
#include "files/error.h"
#include "files/text.h"
#include <catch2/catch.hpp>

TEST_CASE("What a grader tells of its seconds is understood, and the submission stays as it is", "[bench]")
{
    const files_test::TemporaryFolder folder;
    const std::string text = "#include \"texture.h\"\n";
    const std::filesystem::path file = folder.write("texture.cpp", text);
    bench::Grader grader { folder / "" };
    grader.change("texture");
    const bench::GradeTimes times = grader.grade();
    CHECK(files::readText(file) == text);
    REQUIRE(times.files.contains("texture"));
    CHECK(times.files.at("texture").compiling > 0.0);
    CHECK(times.files.at("shading").compiling == 0.0); // there is none
    CHECK(times.files.at("shading").linking == 0.0);
    CHECK(times.files.at("texture").linking > 0.0);
    CHECK(times.rest() > 0.0); // its parts are within the whole
}

TEST_CASE("A submission that is no folder is told in a line", "[bench]")
{
    CHECK_THROWS_AS(bench::Grader("no such folder"), files::Error);
}
