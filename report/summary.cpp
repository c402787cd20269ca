#include "report/summary.h"
#include "files/text.h"
#include "report/html.h"
#include "report/page.h"
#include <fmt/format.h>

namespace report {
namespace {

    using nlohmann::json;

    std::string itemOf(const Section& section, const std::string& what)
    {
        return fmt::format("<li><a href=\"#{}\">{}</a>: {}</li>", section.name, section.title, what);
    }

    std::string missingAnswers(const SectionContent& content)
    {
        std::string items;
        for (const Question& question : content.text.questions)
            if (question.numWords == 0)
                items += itemOf(content.section, "no answer to <q>" + escaped(question.text) + "</q>");
            else if (question.maxWords > 0 && question.numWords > question.maxWords)
                items += itemOf(content.section,
                    fmt::format("{} words, at most {} wanted, on <q>{}</q>", question.numWords, question.maxWords,
                        escaped(question.text)));
        return items;
    }

    std::string missingFigures(const SectionContent& content)
    {
        std::size_t unwritten = 0, failed = 0;
        for (const json& figure : content.figures) {
            unwritten += figure.at("state") == "not written";
            failed += figure.at("state") == "failed";
        }
        std::string items;
        if (unwritten > 0)
            items += itemOf(content.section, fmt::format("{} figures wait for functions", unwritten));
        if (failed > 0)
            items += itemOf(content.section, fmt::format("the code failed in {} figures", failed));
        return items;
    }

    std::string openMatters(const Content& content)
    {
        std::string items;
        for (const SectionContent& section : content.sections)
            items += missingAnswers(section) + missingFigures(section);
        return items.empty()
            ? ""
            : "<details class=\"open\" open><summary>Still open</summary><ul>" + items + "</ul></details>\n";
    }

    std::string scoreOf(const json& part)
    {
        return fmt::format("{:g} / {:g}", part.at("score").get<double>(), part.at("max_score").get<double>());
    }

    // As `raywork grade --json` writes it.
    std::string gradeTable(const json& grade)
    {
        std::string rows;
        for (const Section& section : sections)
            if (const auto part = grade.at("features").find(section.name); part != grade.at("features").end())
                rows += fmt::format("<tr><td>{}</td><td>{}</td></tr>", section.title, scoreOf(*part));
        return fmt::format(
            "<div class=\"panel table\"><table class=\"grade\"><thead><tr><th>Grade</th><th>{}</th></tr></thead>"
            "<tbody>{}</tbody></table></div>\n",
            scoreOf(grade), rows);
    }

    std::string stressRow(const std::string& name, const json& sum)
    {
        return fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{:.2g}</td></tr>", escaped(name),
            sum.at("cases").get<std::size_t>(), sum.at("failed").get<std::size_t>(),
            sum.at("largest_error_ulps").get<double>());
    }

    // As `raywork stress --json` writes it.
    std::string stressTable(const json& stress)
    {
        std::string rows = stressRow("all", stress);
        for (const Section& section : sections)
            if (const auto sum = stress.at("features").find(section.name); sum != stress.at("features").end())
                rows += stressRow(section.title, *sum);
        return "<div class=\"panel table\"><table "
               "class=\"stress\"><thead><tr><th>Stress</th><th>cases</th><th>failed</th>"
               "<th>ulps</th></tr></thead><tbody>"
            + rows + "</tbody></table></div>\n";
    }

    // A file that is no such result is said to be none, rather than stop the report.
    template <typename ToHtml> std::string shown(const Content& content, const char* file, const ToHtml& html)
    {
        const std::filesystem::path path = findResult(content.subject, file);
        if (path.empty())
            return "";
        try {
            return html(json::parse(files::readText(path)));
        } catch (const json::exception& error) {
            return fmt::format("<p class=\"instead\"><b>{}</b> cannot be read: {}</p>", file, escaped(error.what()));
        }
    }

}

std::string summaryOf(const Content& content)
{
    return openMatters(content) + "<div class=\"results\">" + shown(content, "grade.json", gradeTable)
        + shown(content, "stress.json", stressTable) + "</div>";
}

}
