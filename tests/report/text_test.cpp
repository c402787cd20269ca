// What a student writes.
#include "files/temporary_folder.h"
#include "files/text.h"
#include "report/text.h"
#include <catch2/catch.hpp>

using report::questionsIn;

TEST_CASE("Questions have their limits and their answers' words, comments not counted", "[report]")
{
    const auto questions
        = questionsIn("# Title\n\nBefore.\n\n## Why? {words=20}\n\nBecause $a + b$\n<!-- not\nthis -->\n\n"
                      "## And then?\n");
    REQUIRE(questions.size() == 2);
    CHECK(questions[0].text == "Why?");
    CHECK(questions[0].maxWords == 20);
    CHECK(questions[0].numWords == 4);
    CHECK(questions[1].text == "And then?");
    CHECK(questions[1].maxWords == 0);
    CHECK(questions[1].numWords == 0);
}

TEST_CASE("Templates are put there once, and what a student wrote stays", "[report]")
{
    const files_test::TemporaryFolder folder;
    const auto written = folder.write("report/texture.md", "mine\n");
    report::putTemplates(folder / "report");
    CHECK(files::readText(written) == "mine\n");
    for (const report::Section& section : report::sections) {
        INFO(section.name);
        if (section.name != "texture") {
            const std::string text = files::readText(folder / "report" / (section.name + ".md"));
            for (const report::Question& question : questionsIn(text)) {
                CHECK(question.maxWords > 0);
                CHECK(question.numWords == 0);
            }
            CHECK_FALSE(questionsIn(text).empty());
        }
    }
}

TEST_CASE("A question whose heading is gone has no answer", "[report]")
{
    const files_test::TemporaryFolder folder;
    folder.write("texture.md", "Nothing of what was asked.\n");
    const auto* const section = std::ranges::find(report::sections, "texture", &report::Section::name);
    const report::Text text = report::readText(*section, folder / ".");
    REQUIRE_FALSE(text.questions.empty());
    for (const report::Question& question : text.questions)
        CHECK(question.numWords == 0);
}

TEST_CASE("Formulas are typeset, markup stays text, and pictures come from the folder alone", "[report]")
{
    const files_test::TemporaryFolder folder;
    folder.write("texture.md", "$k_d$ <script>x</script> ![a](mine.png) ![b](/etc/passwd) ![c](../other.png)\n");
    folder.write("mine.png", "PNG");
    const auto* const section = std::ranges::find(report::sections, "texture", &report::Section::name);
    const std::string html = report::readText(*section, folder / ".").html;
    CHECK(html.find("<math") != std::string::npos);
    CHECK(html.find("<script") == std::string::npos);
    CHECK(html.find("\"data:image/png;base64,UE5H\"") != std::string::npos);
    CHECK(html.find("passwd") == std::string::npos);
    CHECK(html.find("other") == std::string::npos);
}
