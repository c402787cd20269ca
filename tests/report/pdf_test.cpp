// What Poppler finds in the PDF.
#include "report/made.h"
#include "report/section.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <sstream>

static std::string pdf()
{
    return (report_test::madeReport("reference") / "report.pdf").string();
}

TEST_CASE("The PDF's text can be searched and has the sections in order", "[report]")
{
    const std::string text = report_test::run("pdftotext -layout '" + pdf() + "' -");
    std::size_t from = 0;
    for (const report::Section& section : report::sections) {
        INFO(section.title);
        const std::size_t place = text.find("\f" + section.title + "\n", from); // on a page of its own
        REQUIRE(place != std::string::npos);
        from = place;
    }
    CHECK(text.find("LinearGradient::sample") != std::string::npos);
}

TEST_CASE("The PDF opens with its contents", "[report]")
{
    std::istringstream first(report_test::run("pdftotext -l 1 '" + pdf() + "' -"));
    std::vector<std::string> lines;
    for (std::string line; std::getline(first, line);)
        lines.push_back(line);
    auto from = std::ranges::find(lines, "Contents");
    for (const report::Section& section : report::sections) {
        INFO(section.title);
        REQUIRE(from != lines.end());
        from = std::find(from, lines.end(), section.title);
    }
    CHECK(from != lines.end());
}

TEST_CASE("The PDF's pictures have 150 dots an inch or more", "[report]")
{
    std::istringstream lines(report_test::run("pdfimages -list '" + pdf() + "'"));
    std::string line;
    std::getline(lines, line); // names of columns
    std::getline(lines, line);
    int number = 0;
    for (; std::getline(lines, line); ++number) {
        std::istringstream words(line);
        std::string word;
        for (int column = 0; column < 12; ++column)
            words >> word;
        int xDots = 0, yDots = 0;
        words >> xDots >> yDots;
        INFO(line);
        CHECK(std::min(xDots, yDots) >= 150);
    }
    CHECK(number > 0);
}
