// ./raywork report: draws the figures of a submission, and makes a page and a PDF of them and of what its author
// writes.
#include "app/run_command.h"
#include "report/draw_figure.h"
#include "submission/named_folder.h"
#include "submission/paths.h"
#include "submission/submission.h"
#include <fmt/core.h>

namespace {

namespace fs = std::filesystem;

struct Options {
    std::string submission = "student";
    std::string output = "report-out";
    std::string only;
};

void declare(CLI::App& cli, Options& options)
{
    cli.add_option("submission", options.submission, "Whose code: student, reference, or a submission's folder")
        ->capture_default_str();
    cli.add_option("-o,--output", options.output, "The folder of the report")->capture_default_str();
    cli.add_option(
        "--only", options.only, "Draw this figure, such as texture.bilinear, or a section's, such as texture");
    cli.footer("Exit codes: 0 done, 2 bad input, 69 a program is missing.");
}

report::Subject subjectOf(const Options& options)
{
    const fs::path folder = submission::namedFolder(options.submission);
    submission::Submission built { folder };
    report::Subject subject;
    subject.name = fs::absolute(folder).lexically_normal().filename().string();
    subject.submission = built.buildWholeWorker("figures");
    subject.reference = fs::path(submission::buildDirectory) / "report" / "reference-figures";
    subject.results = { folder / "report", options.output };
    return subject;
}

int run(const Options& options)
{
    const report::Subject subject = subjectOf(options);
    const fs::path figures = fs::path(options.output) / "figures";
    fs::create_directories(figures);
    for (const report::Figure& figure : report::Figure::all())
        if (options.only.empty() || options.only == figure.name || options.only == figure.section)
            if (canBeDrawn(figure, subject)) {
                const nlohmann::json drawn = drawFigure(figure, subject, figures);
                fmt::print(
                    "{}: {} {}\n", figure.name, drawn.at("state").get<std::string>(), drawn.value("message", ""));
            }
    return app::Success;
}

}

int main(int argc, char** argv)
{
    CLI::App cli { "Draws the figures of a submission, and makes a report of them.", "./raywork report" };
    Options options;
    declare(cli, options);
    return app::runCommand(cli, argc, argv, [&] { return run(options); });
}
