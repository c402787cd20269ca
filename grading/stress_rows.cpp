#include "grading/stress_rows.h"
#include "grading/harmless.h"
#include "grading/stress/report.h"
#include "submission/digest.h"
#include "submission/submission.h"
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>

namespace grading {
namespace {

    // What the names of cases begin with, in the order of the report. Only those that ask functions of a submission's
    // file: the rest, such as "shading" and "triangle", passes whatever is handed in.
    struct StressPart {
        std::string name;
        std::string file; // without .cpp
        std::string usualCause;
    };

    const std::array<StressPart, 8> parts { {
        { "gradient", "shading", "0 / 0 between equal positions, or components that are not sorted" },
        { "recursive", "recursive", "an offset that does not suit the scene's scale" },
        { "recursion", "recursive", "a depth or a weight that is lost on the way" },
        { "bvh", "bvh", "0 * infinity in the test of a box, or one without height" },
        { "interpolate", "interpolate", "a division by an area or a length of 0" },
        { "texture", "texture", "an index outside the image, or half a texel forgotten" },
        { "light", "light", "a shadow ray that meets its own surface, or goes beyond the light" },
        { "camera", "render", "a pixel's corner or size that is off" },
    } };

    std::string rowName(const StressPart& part)
    {
        return "stress." + part.name;
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

    // The first failure decides; without one, functions that are not written do.
    Verdict judge(const stress::Report& report)
    {
        std::set<std::string> unwritten;
        for (const auto& [kind, tally] : report.tallies) {
            if (!tally.failures.empty())
                return { statusOf(tally.failures.front()),
                    countOf(report.tallies) + ", the first of them "
                        + stress::paragraph(report, *kind, tally.failures.front()) };
            unwritten.insert(tally.unwrittenFunctions.begin(), tally.unwrittenFunctions.end());
        }
        if (!unwritten.empty())
            return { Status::NotAttempted, fmt::format("not written yet: {}", fmt::join(unwritten, ", ")) };
        return {};
    }

    // A submission's worker with all its files, or why there is none.
    struct StressWorker {
        explicit StressWorker(const std::filesystem::path& folder)
            : submission(folder)
        {
            try {
                file = submission.buildWholeWorker("stressed");
                digest = submission::Digest().addFile(file).hex();
            } catch (const std::runtime_error& error) { // files that each link alone may define the same twice
                errors = error.what();
            }
        }

        submission::Submission submission;
        std::filesystem::path file {};
        std::string digest {}, errors {};
    };

    // So many cases find what is wrong often, in a second; an endless loop is met by many kinds of them.
    Verdict ask(const Assignment& assignment, const StressWorker& worker, const StressPart& part)
    {
        if (!worker.errors.empty())
            return { Status::Refused, worker.errors };
        if (const submission::Part& file = worker.submission.part(part.file); file.state == submission::State::Refused)
            return { Status::Refused, file.message };
        const uint64_t seed = assignment.secret.seedOf(worker.digest, rowName(part));
        const stress::Plan plan {
            .only = part.name, .seed = seed, .numCases = 20000, .patience = std::chrono::seconds(3)
        };
        const stress::Tallies tallies = stress::run(worker.file, plan);
        return judge({ assignment.submission.string(), seed, 0.0, tallies });
    }

    Row toRow(const StressPart& part, double points, const Verdict& verdict)
    {
        const bool isWrong = verdict.status == Status::Wrong;
        return { rowName(part), "stress", verdict.status == Status::Passed ? points : 0.0, points, verdict.status,
            harmless(verdict.message), nullptr, isWrong ? part.usualCause : "" };
    }

}

std::vector<Row> stressRows(const Assignment& assignment, double points, const std::function<void(const Row&)>& onRow)
{
    const StressWorker worker { assignment.submission };
    std::vector<Row> rows;
    for (const StressPart& part : parts) {
        rows.push_back(toRow(part, points / parts.size(), ask(assignment, worker, part)));
        onRow(rows.back());
    }
    return rows;
}

std::vector<std::string> namesOfStressRows()
{
    std::vector<std::string> names;
    for (const StressPart& part : parts)
        names.push_back(rowName(part));
    return names;
}

}
