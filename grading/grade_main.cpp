// ./raywork grade: builds a submission, asks it questions in a process of its own, and tells what it is worth.
#include "files/error.h"
#include "grading/feature.h"
#include "grading/grade.h"
#include "grading/report.h"
#include "grading/validate/command.h"
#include "submission/features.h"
#include "submission/paths.h"
#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <unistd.h>

namespace {

enum ExitCode { Graded = 0, GraderErred = 1, BadInput = 2, GraderFailed = 75 };

struct Options {
    std::string submission;
    std::string onlyFeature;
    std::string json;
    uint64_t seed = 1;
    grading::ValidationOptions validation;
};

// Returns the option that mutates.
const CLI::Option* declareValidation(CLI::App& cli, grading::ValidationOptions& options)
{
    options.bank = std::filesystem::path(submission::sourceDirectory) / "tests" / "grading";
    CLI::App* group = cli.add_option_group("Validation", "of the grader itself");
    group->add_flag("--validate", options.validate, "Grade wrong and right solutions, and print how often that errs");
    group->add_option("--gradings", options.gradings, "Of right solutions, by many seeds [1000]");
    group->add_option("--sample", options.sample, "Grade only so many wrong solutions, and half as many right ones");
    group->add_option("--bank", options.bank, "Folder with the solutions [tests/grading]");
    return group
        ->add_option("--mutants", options.mutatedFiles,
            "Grade the reference with one small change, each in turn, in these files [all]")
        ->expected(0, -1)
        ->check(CLI::IsMember(submission::features));
}

void declare(CLI::App& cli, Options& options)
{
    std::vector<std::string> names;
    for (const grading::Feature& feature : grading::gradedFeatures)
        names.push_back(feature.name);
    cli.add_option("submission", options.submission, "A folder with a submission's files, such as student");
    cli.add_option("--only", options.onlyFeature, "Grade this feature alone")->check(CLI::IsMember(names));
    cli.add_option("--json", options.json, "Write the grade to this file as well");
    cli.add_option("--seed", options.seed, "Of the random inputs [1]");
    const CLI::Option* mutants = declareValidation(cli, options.validation);
    cli.callback([&options, mutants] {
        options.validation.mutate = mutants->count() > 0;
        std::erase(options.validation.mutatedFiles, ""); // which stands for no value at all
        if (options.submission.empty() && !options.validation.wanted())
            throw CLI::RequiredError("submission");
    });
    cli.footer("Exit codes: 0 graded, whatever the score; 1 --validate or --mutants found mistakes of the grader; 2 "
               "bad input; 75 the grader failed.");
}

// On a terminal: what is being done, in place of what was.
void showProgress(std::string_view what)
{
    if (isatty(STDERR_FILENO))
        fmt::print(stderr, "\r\033[K{}", what);
}

ExitCode run(const Options& options)
{
    const auto referenceWorker = std::filesystem::path(submission::buildDirectory) / "grading" / "reference-worker";
    const grading::Assignment assignment { options.submission, referenceWorker, options.onlyFeature, options.seed };
    if (options.validation.wanted())
        return grading::runValidation(options.validation, assignment, showProgress) ? Graded : GraderErred;
    showProgress("compiling");
    const std::vector<grading::Row> rows
        = grading::grade(assignment, [](const grading::Row& row) { showProgress(row.name); });
    showProgress("");
    grading::printTable(rows, isatty(STDOUT_FILENO) != 0);
    if (!options.json.empty())
        grading::writeJson(options.json, rows);
    return Graded;
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
        return run(options);
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
