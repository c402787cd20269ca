// ./raywork grade: builds a submission, asks it questions in a process of its own, and tells what it is worth.
#include "files/error.h"
#include "grading/feature.h"
#include "grading/golden_file.h"
#include "grading/grade.h"
#include "grading/live_reference.h"
#include "grading/report.h"
#include "submission/paths.h"
#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <unistd.h>

namespace {

enum ExitCode { Graded = 0, BadInput = 2, GraderFailed = 75 };

struct Options {
    std::string submission;
    std::string onlyFeature;
    std::string json;
    std::string golden;
    std::string record;
    uint64_t seed = 1;
};

void declare(CLI::App& cli, Options& options)
{
    std::vector<std::string> names;
    for (const grading::Feature& feature : grading::gradedFeatures)
        names.push_back(feature.name);
    CLI::Option* submission
        = cli.add_option("submission", options.submission, "A folder with a submission's files, such as student");
    cli.add_option("--only", options.onlyFeature, "Grade this feature alone")->check(CLI::IsMember(names));
    cli.add_option("--json", options.json, "Write the grade to this file as well");
    cli.add_option("--seed", options.seed, "Of the random inputs [1]");
    cli.add_option("--golden", options.golden, "Take the reference's answers from this file")->check(CLI::ExistingFile);
    CLI::Option* record = cli.add_option("--record", options.record,
        "Write the reference's answers to this file, whatever a submission makes necessary");
    record->excludes("--golden")->excludes(submission);
    cli.callback([&options] {
        if (options.submission.empty() && options.record.empty())
            throw CLI::RequiredError("submission");
    });
    cli.footer("Exit codes: 0 graded, whatever the score; 2 bad input; 75 the grader failed.");
}

// On a terminal: what is being done, in place of what was.
void showProgress(std::string_view what)
{
    if (isatty(STDERR_FILENO))
        fmt::print(stderr, "\r\033[K{}", what);
}

std::shared_ptr<grading::ExpectedAnswers> expectedAnswers(const Options& options)
{
    if (!options.golden.empty())
        return std::make_shared<grading::GoldenFile>(options.golden);
    const auto folder = std::filesystem::path(submission::buildDirectory) / "grading";
    return std::make_shared<grading::LiveReference>(folder / "reference-worker", folder / "answers");
}

// Grades the reference by its own answers, and keeps these.
void record(const Options& options)
{
    const auto reference = std::filesystem::path(submission::sourceDirectory) / "reference";
    const auto source = expectedAnswers(options);
    const auto recorder = std::make_shared<grading::Recorder>(*source);
    showProgress("compiling");
    const std::vector<grading::Row> rows = grading::grade({ reference, recorder, options.onlyFeature, options.seed },
        [](const grading::Row& row) { showProgress(row.name); });
    showProgress("");
    for (const grading::Row& row : rows)
        if (row.status != grading::Status::Passed)
            throw std::runtime_error(fmt::format("the reference fails {}: {}", row.name, row.message));
    recorder->write(options.record);
}

void run(const Options& options)
{
    const grading::Assignment assignment { options.submission, expectedAnswers(options), options.onlyFeature,
        options.seed };
    showProgress("compiling");
    const std::vector<grading::Row> rows
        = grading::grade(assignment, [](const grading::Row& row) { showProgress(row.name); });
    showProgress("");
    grading::printTable(rows, isatty(STDOUT_FILENO) != 0);
    if (!options.json.empty())
        grading::writeJson(options.json, rows);
}

}

int main(int argc, char** argv)
{
    CLI::App cli { "Grades a submission.", "./raywork grade" };
    Options options;
    declare(cli, options);
    try {
        cli.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return cli.exit(error) == 0 ? Graded : BadInput;
    }
    try {
        options.record.empty() ? run(options) : record(options);
        return Graded;
    } catch (const files::Error& error) {
        showProgress("");
        fmt::print(stderr, "{}\n", error.what());
        return BadInput;
    } catch (const std::exception& error) {
        showProgress("");
        fmt::print(stderr, "the grader failed: {}\n", error.what());
        return GraderFailed;
    }
}
