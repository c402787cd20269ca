#pragma once
#include "report/section.h"
#include <filesystem>
#include <string>
#include <vector>

namespace report {

// A question of a template: a heading of the second level with the most words that an answer may have, such as
// "## What is a lobe? {words=80}".
struct Question {
    std::string text;
    std::size_t maxWords = 0;
    std::string answer;
    std::size_t numWords = 0; // of the answer
};

// What a student writes about a section: DIR/report/<section>.md.
struct Text {
    std::vector<Question> questions; // the template's, with the student's answers
    std::string html; // of the whole text
};

// Puts the templates there that are missing; what is there stays as it is.
void putTemplates(const std::filesystem::path& folder);

// Reads a section's text. Pandoc turns it into HTML, formulas into MathML. Throws files::Error, and ProgramFailed.
[[nodiscard]] Text readText(const Section& section, const std::filesystem::path& folder);

// The questions in a Markdown text, each with what stands under it; comments count for nothing.
[[nodiscard]] std::vector<Question> questionsIn(const std::string& markdown);

}
