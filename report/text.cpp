#include "report/text.h"
#include "files/text.h"
#include "report/markdown.h"
#include "submission/paths.h"
#include <algorithm>
#include <iterator>
#include <regex>
#include <sstream>

namespace report {
namespace {

    namespace fs = std::filesystem;

    fs::path templateOf(const Section& section)
    {
        return fs::path(submission::sourceDirectory) / "report" / "text" / (section.name + ".md");
    }

    std::string withoutComments(const std::string& markdown)
    {
        static const std::regex comment("<!--[^]*?-->");
        return std::regex_replace(markdown, comment, "");
    }

    // The page has the section's title already.
    std::string withoutTitle(const std::string& markdown)
    {
        static const std::regex title("(^|\\n)# [^\\n]*");
        return std::regex_replace(markdown, title, "$1");
    }

    std::size_t countWords(const std::string& text)
    {
        std::istringstream stream(text);
        return static_cast<std::size_t>(
            std::distance(std::istream_iterator<std::string>(stream), std::istream_iterator<std::string>()));
    }

    // "## text {words=80}"
    bool readHeading(const std::string& line, Question& question)
    {
        static const std::regex heading(R"(##\s+(.*?)\s*(\{words=(\d+)\})?\s*)");
        std::smatch match;
        if (!std::regex_match(line, match, heading))
            return false;
        question = { match[1], match[3].matched ? std::stoul(match[3]) : 0, "", 0 };
        return true;
    }

    // The template asks; a heading that a student removed has no answer.
    std::vector<Question> answered(std::vector<Question> asked, const std::vector<Question>& answers)
    {
        for (Question& question : asked) {
            const auto found = std::ranges::find(answers, question.text, &Question::text);
            if (found == answers.end())
                continue;
            question.answer = found->answer;
            question.numWords = found->numWords;
        }
        return asked;
    }

}

void putTemplates(const fs::path& folder)
{
    fs::create_directories(folder);
    for (const Section& section : sections)
        if (const fs::path path = folder / (section.name + ".md"); !fs::exists(path))
            files::writeText(path, files::readText(templateOf(section)));
}

std::vector<Question> questionsIn(const std::string& markdown)
{
    std::vector<Question> questions;
    std::istringstream lines(withoutComments(markdown));
    Question heading;
    for (std::string line; std::getline(lines, line);)
        if (readHeading(line, heading))
            questions.push_back(heading);
        else if (!questions.empty())
            questions.back().answer += line + "\n";
    for (Question& question : questions)
        question.numWords = countWords(question.answer);
    return questions;
}

Text readText(const Section& section, const fs::path& folder)
{
    const std::string text = files::readText(folder / (section.name + ".md"));
    return { answered(questionsIn(files::readText(templateOf(section))), questionsIn(text)),
        toHtml(withoutTitle(withoutComments(text)), folder) };
}

}
