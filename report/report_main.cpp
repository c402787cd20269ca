// ./raywork report: draws the figures of a submission, and makes a page and a PDF of them and of what its author
// writes.
#include "app/run_command.h"
#include "report/program.h"
#include "report/report.h"

static void declare(CLI::App& cli, report::Options& options)
{
    cli.add_option("submission", options.submission, "Whose code: student, reference, or a submission's folder")
        ->capture_default_str();
    cli.add_option("-o,--output", options.output, "The folder of the report [the submission's name, -report]");
    cli.add_option("--only", options.only, "Draw this figure alone, such as texture.bilinear, or a section's");
    cli.footer("What you write goes into the submission's report/*.md, which the first call puts there.\n"
               "A figure in which the code fails says so in its place.\n"
               "Exit codes: 0 done, 2 bad input, 69 gnuplot, Pandoc or Chromium is missing or failed.");
}

static int run(const report::Options& options)
{
    try {
        report::makeReport(options);
        return app::Success;
    } catch (const report::ProgramFailed& error) {
        fmt::print(stderr, "{}\n", error.what());
        return app::Unavailable;
    }
}

int main(int argc, char** argv)
{
    CLI::App cli { "Draws the figures of a submission, and makes a report of them.", "./raywork report" };
    report::Options options;
    declare(cli, options);
    return app::runCommand(cli, argc, argv, [&] { return run(options); });
}
