// ./raywork grade: builds a submission, asks it questions in a process of its own, and tells what it is worth.
#include "files/error.h"
#include "grading/feature.h"
#include "grading/golden_file.h"
#include "grading/grade.h"
#include "grading/live_reference.h"
#include "grading/outputs.h"
#include "grading/report.h"
#include "grading/supervisor.h"
#include "grading/watch.h"
#include "sandbox/bubblewrap.h"
#include "submission/paths.h"
#include <CLI/CLI.hpp>
#include <chrono>
#include <fmt/core.h>
#include <mutex>
#include <unistd.h>

namespace {

enum ExitCode { Graded = 0, BadInput = 2, GraderFailed = 75 };

struct Options {
    std::string submission;
    std::string onlyFeature;
    std::string golden;
    std::string record;
    uint64_t seed = 1;
    std::string secretFile;
    std::string referenceWorker = std::string(submission::buildDirectory) + "/grading/reference-worker";
    std::string sandbox = "auto";
    bool isFresh = false;
    bool isWatching = false;
    grading::Outputs outputs;
};

void declare(CLI::App& cli, grading::Outputs& outputs)
{
    cli.add_option("--json", outputs.json, "Write the grade to this file as well, after each check");
    cli.add_option("--html", outputs.html, "Write a page for the student, with the pictures, to this file");
    cli.add_option("--junit", outputs.junit, "Write JUnit's XML to this file");
    cli.add_option("--gradescope", outputs.gradescope, "Write Gradescope's results.json to this file");
    cli.add_option(
           "--hide", outputs.hidden, "Of checks like this, such as 'texture.*', show the name alone; repeatable")
        ->allow_extra_args(false);
}

void declare(CLI::App& cli, Options& options)
{
    std::vector<std::string> names;
    for (const grading::Feature& feature : grading::gradedFeatures)
        names.push_back(feature.name);
    CLI::Option* submission
        = cli.add_option("submission", options.submission, "A folder with a submission's files, such as student");
    cli.add_option("--only", options.onlyFeature, "Grade this feature alone")->check(CLI::IsMember(names));
    CLI::Option* const seed = cli.add_option("--seed", options.seed, "Of the random inputs [1]");
    cli.add_option("--secret-file", options.secretFile, "The random inputs follow from its contents, 16 bytes or more")
        ->excludes(seed);
    cli.add_option("--sandbox", options.sandbox,
           "auto: locked in if this machine can, and says if not; required: or not at all; off: with limits alone")
        ->check(CLI::IsMember({ "auto", "required", "off" }));
    cli.add_option("--reference-worker", options.referenceWorker, "The program whose answers are taken for right");
    cli.add_flag("--fresh", options.isFresh, "Repeat also the checks that see nothing changed since the last time");
    cli.add_flag("--watch", options.isWatching, "Grade again after each change of a file, until interrupted");
    cli.add_option("--golden", options.golden, "Take the reference's answers from this file")->check(CLI::ExistingFile);
    cli.add_option("--record", options.record, "Write the reference's answers to this file, for any submission")
        ->excludes("--golden")
        ->excludes(submission);
    declare(cli, options.outputs);
    cli.callback([&options] {
        if (options.submission.empty() && options.record.empty())
            throw CLI::RequiredError("submission");
    });
    cli.footer("Exit codes: 0 graded, whatever the score; 2 bad input; 75 the grader failed.");
}

void chooseSandbox(const std::string& sandbox)
{
    if (sandbox == "off")
        sandbox::turnOffBubblewrap();
    if (sandbox == "required" && !sandbox::whyNoBubblewrap().empty())
        throw std::runtime_error("--sandbox required: " + sandbox::whyNoBubblewrap());
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
    return std::make_shared<grading::LiveReference>(options.referenceWorker, folder / "answers");
}

// Grades the reference by its own answers, and keeps these.
void record(const Options& options)
{
    const auto reference = std::filesystem::path(submission::sourceDirectory) / "reference";
    const auto source = expectedAnswers(options);
    const auto recorder = std::make_shared<grading::Recorder>(*source);
    showProgress("compiling");
    const std::vector<grading::Row> rows
        = grading::grade({ reference, recorder, options.onlyFeature, grading::Secret(options.seed), true },
            [](const grading::Row& row) { showProgress(row.name); });
    showProgress("");
    for (const grading::Row& row : rows)
        if (row.status != grading::Status::Passed)
            throw std::runtime_error(fmt::format("the reference fails {}: {}", row.name, row.message));
    recorder->write(options.record);
}

// Of a folder, "a/b/" or "." too.
std::string nameOf(const std::filesystem::path& folder)
{
    return std::filesystem::weakly_canonical(folder).filename().string();
}

// The grade as it grows. Checks end on several threads.
class GrowingGrade {
public:
    explicit GrowingGrade(const Options& options)
        : m_outputs(options.outputs)
        , m_start(std::chrono::steady_clock::now())
        , m_grade { {}, nameOf(options.submission), 0.0, false, sandbox::whyNoBubblewrap() }
    {
    }

    // What there is of it is written after each check: a grading that is cut off keeps that.
    void add(const grading::Row& row)
    {
        const std::lock_guard lock(m_mutex);
        showProgress(row.name);
        m_grade.rows.push_back(grading::hide({ row }, m_outputs.hidden)[0]);
        if (!m_outputs.json.empty())
            grading::writeJson(m_outputs.json, m_grade);
    }

    [[nodiscard]] grading::Grade complete(std::vector<grading::Row> rows)
    {
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - m_start;
        m_grade.rows = grading::hide(std::move(rows), m_outputs.hidden);
        m_grade.seconds = elapsed.count();
        m_grade.isComplete = true;
        return m_grade;
    }

private:
    const grading::Outputs& m_outputs;
    std::chrono::steady_clock::time_point m_start;
    grading::Grade m_grade;
    std::mutex m_mutex;
};

void gradeOnce(const Options& options)
{
    const grading::Secret secret = options.secretFile.empty()
        ? grading::Secret(options.seed)
        : grading::Secret(std::filesystem::path(options.secretFile));
    const grading::Assignment assignment { options.submission, expectedAnswers(options), options.onlyFeature, secret,
        options.isFresh };
    GrowingGrade growing { options };
    showProgress("compiling");
    const grading::Grade grade
        = growing.complete(grading::grade(assignment, [&](const grading::Row& row) { growing.add(row); }));
    showProgress("");
    grading::writeOutputs(options.outputs, grade);
    grading::printTable(grade, isatty(STDOUT_FILENO) != 0);
}

int run(const Options& options)
{
    try {
        chooseSandbox(options.sandbox);
        grading::expectPatternsMatch(options.outputs.hidden);
        if (!options.record.empty())
            record(options);
        else if (!options.isWatching)
            gradeOnce(options);
        else
            grading::watch(options.submission, [&] { gradeOnce(options); });
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
    return grading::runSupervised([&] { return run(options); }, GraderFailed);
}
