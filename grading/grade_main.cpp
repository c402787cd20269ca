// ./raywork grade: builds a submission, asks it questions in a process of its own, and tells what it is worth.
#include "files/error.h"
#include "grading/golden_file.h"
#include "grading/grade.h"
#include "grading/growing_grade.h"
#include "grading/live_reference.h"
#include "grading/options.h"
#include "grading/report.h"
#include "grading/stress_rows.h"
#include "grading/supervisor.h"
#include "grading/watch.h"
#include "sandbox/bubblewrap.h"
#include "submission/cache.h"
#include "submission/paths.h"
#include <algorithm>
#include <fmt/core.h>
#include <iterator>
#include <unistd.h>
#include <utility>

namespace {

using grading::Options;

enum ExitCode { Graded = 0, GraderErred = 1, BadInput = 2, GraderFailed = 75 };

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

std::filesystem::path keptFolder()
{
    return submission::keptFolder() / "grading";
}

std::shared_ptr<grading::ExpectedAnswers> expectedAnswers(const Options& options)
{
    if (!options.golden.empty())
        return std::make_shared<grading::GoldenFile>(options.golden);
    return std::make_shared<grading::LiveReference>(options.referenceWorker, keptFolder() / "answers");
}

grading::Assignment assignmentOf(const Options& options)
{
    const grading::Secret secret = options.secretFile.empty()
        ? grading::Secret(options.seed)
        : grading::Secret(std::filesystem::path(options.secretFile));
    grading::Assignment assignment { options.submission, expectedAnswers(options), options.onlyFeature, secret };
    assignment.wantsObservations = true;
    if (!options.isFresh) {
        assignment.knownRows = keptFolder() / "rows";
        assignment.knownDrawings = keptFolder() / "drawings";
    }
    return assignment;
}

// Its rows belong to no feature.
bool wantsStress(const Options& options)
{
    return options.stressPoints && options.onlyFeature.empty();
}

void gradeOnce(const Options& options)
{
    grading::GrowingGrade growing { options.submission, options.outputs };
    showProgress("compiling");
    const auto onRow = [&](const grading::Row& row) {
        showProgress(row.name);
        growing.add(row);
    };
    const grading::Assignment assignment = assignmentOf(options);
    grading::Outcome outcome = grading::grade(assignment, onRow);
    if (wantsStress(options))
        std::ranges::move(
            grading::stressRows(assignment, *options.stressPoints, onRow), std::back_inserter(outcome.rows));
    const grading::Grade grade = growing.complete(std::move(outcome.rows), std::move(outcome.observations));
    showProgress("");
    grading::writeOutputs(options.outputs, grade);
    if (!options.times.empty())
        grading::writeTimes(options.times, outcome.times);
    grading::printTable(grade, isatty(STDOUT_FILENO) != 0);
}

// Grades the reference by its own answers, and keeps these.
void record(const Options& options)
{
    grading::Assignment assignment = assignmentOf(options);
    const auto recorder = std::make_shared<grading::Recorder>(*assignment.expected);
    const auto source = std::exchange(assignment.expected, recorder);
    assignment.submission = std::filesystem::path(submission::sourceDirectory) / "reference";
    assignment.knownRows.clear(); // a row that is known asks nothing
    assignment.knownDrawings.clear();
    showProgress("compiling");
    const auto outcome = grading::grade(assignment, [](const grading::Row& row) { showProgress(row.name); });
    showProgress("");
    for (const grading::Row& row : outcome.rows)
        if (row.status != grading::Status::Passed)
            throw std::runtime_error(fmt::format("the reference fails {}: {}", row.name, row.message));
    recorder->write(options.record);
}

ExitCode run(const Options& options)
{
    chooseSandbox(options.sandbox);
    grading::expectPatternsMatch(
        options.outputs.hidden, wantsStress(options) ? grading::namesOfStressRows() : std::vector<std::string>());
    if (options.validation.wanted())
        return grading::runValidation(options.validation, expectedAnswers(options), showProgress) ? Graded
                                                                                                  : GraderErred;
    if (options.record.empty())
        gradeOnce(options);
    else
        record(options);
    return Graded;
}

int runAndReport(const Options& options)
{
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

}

int main(int argc, char** argv)
{
    Options options;
    if (const std::optional<int> exitCode = grading::parse(argc, argv, options))
        return *exitCode;
    if (options.isWatching) // until the user interrupts it
        grading::watch(options.submission, [&] { (void)runAndReport(options); });
    return grading::runSupervised([&] { return runAndReport(options); }, GraderFailed);
}
