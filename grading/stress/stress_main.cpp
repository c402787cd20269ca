// ./raywork stress: asks a submission's functions what breaks naive code, and judges by oracles of more precision.
#include "app/progress_bar.h"
#include "files/error.h"
#include "grading/stress/report.h"
#include "grading/write_whole.h"
#include "submission/features.h"
#include "submission/named_folder.h"
#include "submission/submission.h"
#include "values/stopwatch.h"
#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace {

struct Options {
    std::string submission = "student";
    std::string alone; // a file
    std::filesystem::path json;
    stress::Plan plan;
};

enum ExitCode { AllPassed = 0, SomeFailed = 1, BadInput = 2, ProgramFailed = 75 };

void declare(CLI::App& cli, Options& options)
{
    cli.add_option("submission", options.submission, "student, reference, or a submission's folder [student]");
    cli.add_option("--only", options.plan.only, "Only this feature, or what has this name up to a dot");
    cli.add_option("--alone", options.alone, "This file beside the reference's others [all files together]")
        ->check(CLI::IsMember(submission::features));
    cli.add_option("--json", options.json, "Write what was found to this file as well");
    cli.add_option("--seed", options.plan.seed, "Of the random cases [1]");
    cli.add_option("--cases", options.plan.numCases, "Random cases in all, about [ten million and more]")
        ->check(CLI::PositiveNumber);
    cli.add_option("--case", options.plan.input, "This one alone, of the one name that --only gives")
        ->check(CLI::NonNegativeNumber);
    cli.footer("Exit codes: 0 all passed, 1 some failed or were not attempted, 2 bad input, 75 the program failed.");
}

std::filesystem::path build(submission::Submission& submission, const std::string& alone)
{
    if (alone.empty())
        return submission.buildWholeWorker("stressed");
    const submission::Program worker = submission.buildStressedWorker(alone);
    if (!worker.errors.empty())
        throw std::runtime_error(worker.errors);
    return worker.file;
}

std::filesystem::path build(const Options& options)
{
    submission::Submission submission { submission::namedFolder(options.submission) };
    std::filesystem::path worker = build(submission, options.alone);
    for (const std::string& file : submission.names())
        if (const submission::Part& part = submission.part(file); part.state == submission::State::Refused)
            fmt::print(stderr, "{}.cpp is left out. {}", file, part.message);
    return worker;
}

ExitCode run(const Options& options)
{
    const std::filesystem::path worker = build(options);
    const values::Stopwatch watch;
    const stress::Tallies tallies = stress::run(worker, options.plan, app::drawProgressBar);
    app::clearProgressBar();
    const stress::Report report { options.submission, options.alone, options.plan.seed, watch.seconds(), tallies };
    if (!options.json.empty())
        grading::writeWhole(options.json, stress::json(report));
    fmt::print("{}", stress::table(report));
    return stress::allPassed(report) ? AllPassed : SomeFailed;
}

int runAndReport(const Options& options)
{
    try {
        return run(options);
    } catch (const files::Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return BadInput;
    } catch (const std::invalid_argument& error) {
        fmt::print(stderr, "{}\n", error.what());
        return BadInput;
    } catch (const std::exception& error) {
        app::clearProgressBar();
        fmt::print(stderr, "the stress test failed: {}\n", error.what());
        return ProgramFailed;
    }
}

}

int main(int argc, char** argv)
{
    CLI::App cli { "Asks a submission's functions what breaks naive code.", "./raywork stress" };
    Options options;
    declare(cli, options);
    try {
        cli.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return cli.exit(error) == 0 ? AllPassed : BadInput;
    }
    return runAndReport(options);
}
