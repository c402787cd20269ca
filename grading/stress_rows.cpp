#include "grading/stress_rows.h"
#include "grading/harmless.h"
#include "grading/stress/report.h"
#include "submission/submission.h"
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>

namespace grading {
namespace {

    struct StressedFile {
        std::string name; // without .cpp
        std::vector<std::string> cases; // what the names begin with; the others ask the framework alone
        std::string usualCause;
    };

    const std::array<StressedFile, 7> stressedFiles { {
        { "shading", { "gradient" }, "0 / 0 between equal positions, or components that are not sorted" },
        { "recursive", { "recursive", "recursion" }, "an offset that does not follow the scene's scale" },
        { "bvh", { "bvh" }, "0 * infinity in the test of a box, or a box without height" },
        { "interpolate", { "interpolate" }, "a division by an area or a length of 0" },
        { "texture", { "texture" }, "an index outside the image, or half a texel forgotten" },
        { "light", { "light" }, "a shadow ray that meets its own surface, or goes beyond the light" },
        { "render", { "camera" }, "a pixel's corner or size that is off" },
    } };

    std::string rowName(const StressedFile& file)
    {
        return "stress." + file.name;
    }

    struct Verdict {
        Status status = Status::Passed;
        std::string message;
    };

    Status statusOf(const stress::Failure& failure)
    {
        if (failure.word == "timed out")
            return Status::TimedOut;
        return failure.word == "crashed" || failure.word == "threw" ? Status::Crashed : Status::Wrong;
    }

    std::string countOf(const stress::Tallies& tallies)
    {
        std::size_t failed = 0, asked = 0;
        for (const auto& [kind, tally] : tallies) {
            failed += tally.failed * kind->casesEach;
            asked += tally.asked * kind->casesEach;
        }
        return fmt::format("{} of {} cases failed", failed, asked);
    }

    // What was asked may be a whole scene, which the line that asks again tells in full.
    stress::Failure shortened(stress::Failure failure)
    {
        constexpr std::size_t longest = 600;
        if (failure.asked.size() > longest)
            failure.asked.replace(longest, std::string::npos, " ...");
        return failure;
    }

    // The first failure decides; without one, functions that are not written do.
    Verdict judge(const stress::Report& report)
    {
        std::set<std::string> unwritten;
        for (const auto& [kind, tally] : report.tallies) {
            if (!tally.failures.empty())
                return { statusOf(tally.failures.front()),
                    countOf(report.tallies) + ", the first of them\n"
                        + stress::paragraph(report, *kind, shortened(tally.failures.front())) };
            unwritten.insert(tally.unwrittenFunctions.begin(), tally.unwrittenFunctions.end());
        }
        if (!unwritten.empty())
            return { Status::NotAttempted, fmt::format("not written yet: {}", fmt::join(unwritten, ", ")) };
        return {};
    }

    // In a second: what is wrong often is found. Of a file that hangs more need not be known.
    stress::Tallies askAll(const std::filesystem::path& worker, const StressedFile& file, uint64_t seed)
    {
        stress::Plan plan {
            .seed = seed, .numCases = 20000, .patience = std::chrono::seconds(3), .stopsWhenGivenUp = true
        };
        stress::Tallies tallies;
        for (const std::string& cases : file.cases) {
            plan.only = cases;
            tallies.merge(stress::run(worker, plan));
        }
        return tallies;
    }

    Verdict ask(const Assignment& assignment, submission::Submission& submission, const StressedFile& file)
    {
        if (const std::string& why = submission.whyUntouched(file.name); !why.empty())
            return { Status::NotAttempted, why };
        const submission::Program worker = submission.buildStressedWorker(file.name);
        if (const submission::Part& part = submission.part(file.name); part.state == submission::State::Refused)
            return { Status::Refused, part.message };
        if (!worker.errors.empty())
            return { Status::Refused, worker.errors };
        const uint64_t seed = assignment.secret.seedOf(worker.key, rowName(file));
        const stress::Tallies tallies = askAll(worker.file, file, seed);
        return judge({ assignment.submission.string(), file.name, seed, 0.0, tallies });
    }

    Row toRow(const StressedFile& file, double points, const Verdict& verdict)
    {
        const bool isWrong = verdict.status == Status::Wrong;
        return { rowName(file), "stress", verdict.status == Status::Passed ? points : 0.0, points, verdict.status,
            harmless(verdict.message), nullptr, isWrong ? file.usualCause : "" };
    }

}

std::vector<Row> stressRows(const Assignment& assignment, double points, const std::function<void(const Row&)>& onRow)
{
    submission::Submission submission { assignment.submission };
    std::vector<Row> rows;
    for (const StressedFile& file : stressedFiles) {
        rows.push_back(toRow(file, points / stressedFiles.size(), ask(assignment, submission, file)));
        onRow(rows.back());
    }
    return rows;
}

std::vector<std::string> namesOfStressRows()
{
    std::vector<std::string> names;
    for (const StressedFile& file : stressedFiles)
        names.push_back(rowName(file));
    return names;
}

}
