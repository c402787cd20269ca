#include "report/page.h"
#include "report/figure.h"
#include "report/figure_html.h"
#include "report/html.h"
#include "report/page_frame.h"
#include "report/summary.h"
#include <fmt/format.h>

namespace report {
namespace {

    using nlohmann::json;

    std::string figuresOf(const std::vector<json>& figures, const Content& content)
    {
        std::string html;
        for (const json& figure : figures)
            html += toHtml(figure, content.figures,
                fmt::format("./raywork report {} --only {}", content.folder, figure.at("name").get<std::string>()));
        return html;
    }

    std::string headed(const std::string& title, const std::string& html)
    {
        return html.empty() ? html : fmt::format("<h3>{}</h3>\n{}", title, html);
    }

    std::string locationsOf(const std::vector<Location>& locations)
    {
        std::string rows;
        for (const Location& location : locations)
            rows += fmt::format("<tr><td><code>{}</code></td><td>{}</td></tr>", escaped(location.function),
                location.file.empty() ? "not there"
                                      : fmt::format("<code>{}:{}</code>", escaped(location.file), location.line));
        return "<table class=\"locations\"><tbody>" + rows + "</tbody></table>";
    }

    std::string sectionOf(const SectionContent& content, const Content& whole)
    {
        std::vector<json> drawings, pictures;
        for (const json& figure : content.figures)
            (figure.at("part") == Part::VisualDebugging ? drawings : pictures).push_back(figure);
        return fmt::format(
            "<section id=\"{0}\">\n<h2>{1}</h2>\n<h3>Description</h3>\n<div class=\"prose\">{2}</div>\n{3}{4}{5}"
            "</section>\n",
            content.section.name, content.section.title, content.text.html,
            headed("Visual debugging", figuresOf(drawings, whole)),
            headed("Rendered images", figuresOf(pictures, whole)), headed("Location", locationsOf(content.locations)));
    }

    std::string navigation(const Content& content)
    {
        std::string links;
        for (const SectionContent& section : content.sections)
            links += fmt::format("<a href=\"#{}\">{}</a>\n", section.section.name, section.section.title);
        return content.measurements.empty() ? links : links + "<a href=\"#measurements\">Accuracy and speed</a>\n";
    }

    std::string measurementsOf(const Content& content)
    {
        return content.measurements.empty() ? ""
                                            : "<section id=\"measurements\">\n<h2>Accuracy and speed</h2>\n"
                + figuresOf(content.measurements, content) + "</section>\n";
    }

    // Left to right, once: what is put in may contain braces.
    std::string fill(std::string_view frame, const std::vector<std::pair<std::string_view, std::string>>& parts)
    {
        std::string page;
        for (const auto& [name, text] : parts) {
            const std::size_t place = frame.find(name);
            page += frame.substr(0, place);
            page += text;
            frame.remove_prefix(place + name.size());
        }
        return page.append(frame);
    }

}

std::string makePage(const Content& content)
{
    std::string body;
    for (const SectionContent& section : content.sections)
        body += sectionOf(section, content);
    const std::string name = escaped(content.subject.name);
    return fill(pageFrame,
        { { "{{title}}", name }, { "{{heading}}", name }, { "{{summary}}", summaryOf(content) },
            { "{{navigation}}", navigation(content) }, { "{{sections}}", body + measurementsOf(content) } });
}

}
