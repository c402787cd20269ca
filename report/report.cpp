#include "report/report.h"
#include "files/error.h"
#include "files/text.h"
#include "report/draw_figure.h"
#include "report/page.h"
#include "report/pdf.h"
#include "submission/named_folder.h"
#include "submission/paths.h"
#include "submission/submission.h"
#include <algorithm>
#include <fmt/core.h>
#include <tbb/parallel_for.h>

namespace report {
namespace {

    namespace fs = std::filesystem;
    using nlohmann::json;

    std::string nameOf(const fs::path& folder)
    {
        return fs::absolute(folder / "").lexically_normal().parent_path().filename().string();
    }

    Subject subjectOf(const fs::path& folder, const fs::path& output)
    {
        submission::Submission built { folder };
        Subject subject;
        subject.name = nameOf(folder);
        subject.submission = built.buildWholeWorker("figures");
        for (const std::string& name : built.names())
            if (const submission::Part& part = built.part(name); part.state == submission::State::Refused)
                fmt::print(stderr, "{}.cpp is left out. {}", name, part.message);
        subject.reference = fs::path(submission::buildDirectory) / "report" / "reference-figures";
        subject.results = { folder / "report", output };
        return subject;
    }

    bool isWanted(const Figure& figure, const std::string& only)
    {
        return only.empty() || only == figure.name || only == figure.section;
    }

    void expectFigure(const std::string& only)
    {
        if (std::ranges::any_of(Figure::all(), [&](const Figure& figure) { return isWanted(figure, only); }))
            return;
        std::string names;
        for (const Figure& figure : Figure::all())
            names += "\n  " + figure.name;
        throw std::invalid_argument(
            "found no figure '" + only + "', expected one of these, or a section of them:" + names);
    }

    void tell(const DrawnFigure& figure)
    {
        const json& about = figure.description;
        fmt::print("{:<28} {}{}{}{}\n", about.at("name").get<std::string>(), about.at("state").get<std::string>(),
            figure.isNew ? "" : ", unchanged", about.contains("message") ? ": " : "", about.value("message", ""));
        std::fflush(stdout);
    }

    std::vector<json> drawFigures(const Options& options, const Subject& subject)
    {
        std::vector<json> drawn;
        for (const Figure& figure : Figure::all())
            if (isWanted(figure, options.only) && canBeDrawn(figure, subject)) {
                DrawnFigure figureDrawn = drawFigure(figure, subject, options.output / "figures");
                tell(figureDrawn);
                drawn.push_back(std::move(figureDrawn.description));
            }
        return drawn;
    }

    std::vector<json> figuresOf(const std::string& section, const std::vector<json>& figures)
    {
        std::vector<json> found;
        for (const json& figure : figures)
            if (figure.at("name").get<std::string>().starts_with(section + "."))
                found.push_back(figure);
        return found;
    }

    SectionContent contentOf(const Section& section, const fs::path& folder, const std::vector<json>& figures)
    {
        SectionContent content { section, readText(section, folder / "report"), {}, figuresOf(section.name, figures) };
        for (const std::string& function : functionsOf(section))
            content.locations.push_back(locate(function, folder, section.file + ".cpp"));
        return content;
    }

    Content contentOf(
        const Options& options, const Subject& subject, const fs::path& folder, const std::vector<json>& figures)
    {
        Content content { subject, options.submission, options.output / "figures", {}, figuresOf("accuracy", figures) };
        std::vector<std::unique_ptr<SectionContent>> parts(sections.size());
        tbb::parallel_for(std::size_t(0), sections.size(), [&](std::size_t i) {
            parts[i] = std::make_unique<SectionContent>(contentOf(sections[i], folder, figures));
        });
        for (const auto& part : parts)
            content.sections.push_back(*part);
        for (json& figure : figuresOf("speed", figures))
            content.measurements.push_back(std::move(figure));
        return content;
    }

    // Printing takes longer than all else where nothing changed.
    void writePage(const Options& options, const std::string& html)
    {
        const fs::path page = options.output / "index.html", pdf = options.output / "report.pdf";
        if (fs::exists(page) && fs::exists(pdf) && files::readText(page) == html)
            return;
        fs::remove(pdf);
        files::writeText(page, html);
        printPdf(page, pdf);
    }

}

void makeReport(Options options)
{
    if (!options.only.empty())
        expectFigure(options.only);
    const fs::path folder = submission::namedFolder(options.submission);
    if (options.output.empty())
        options.output = nameOf(folder) + "-report";
    const Subject subject = subjectOf(folder, options.output);
    fs::create_directories(options.output / "figures");
    const std::vector<json> figures = drawFigures(options, subject);
    if (!options.only.empty())
        return;
    putTemplates(folder / "report");
    writePage(options, makePage(contentOf(options, subject, folder, figures)));
    fmt::print("{} and {}\n", (options.output / "index.html").string(), (options.output / "report.pdf").string());
}

}
