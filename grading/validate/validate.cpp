#include "grading/validate/validate.h"
#include "grading/feature.h"
#include "grading/validate/folder.h"
#include <atomic>
#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace grading {
namespace {

    // A solution to be graded with a seed, and the rows that lost points.
    struct Grading {
        const Solution* solution;
        uint64_t seed;
        bool isWrong;
        std::vector<Row> lost {};
    };

    std::vector<Grading> gradingsOf(const Bank& bank, std::size_t acceptedGradings, uint64_t firstSeed)
    {
        std::vector<Grading> gradings;
        for (const Solution& solution : bank.wrong)
            gradings.push_back({ &solution, firstSeed, true });
        const std::size_t accepted = bank.accepted.size();
        const std::size_t seeds = accepted == 0 ? 0 : (acceptedGradings + accepted - 1) / accepted;
        for (const Solution& solution : bank.accepted)
            for (std::size_t i = 0; i < seeds; ++i)
                gradings.push_back({ &solution, firstSeed + i, false });
        return gradings;
    }

    // In a folder for each of the gradings that run side by side. The features that a solution leaves as they are have
    // the same rows with the same seed: these are asked for once.
    std::vector<Row> lostRows(const Grading& grading, const std::shared_ptr<ExpectedAnswers>& expected)
    {
        const int thread = std::max(tbb::this_task_arena::current_thread_index(), 0);
        const auto folder = validationFolder() / fmt::format("solution-{}", thread);
        writeChangedReference(folder, grading.solution->file, grading.solution->text);
        std::vector<Row> rows = grade({ folder, expected, "", Secret(grading.seed), validationFolder() / "rows" }).rows;
        std::erase_if(rows, [](const Row& row) { return row.score >= row.maxScore; });
        for (Row& row : rows)
            row.pictures.reset(); // too much for a thousand gradings
        return rows;
    }

    void countWrong(const Grading& grading, GraderErrors& errors)
    {
        const Solution& solution = *grading.solution;
        std::set<std::string> failed;
        for (const Row& row : grading.lost) {
            failed.insert(row.feature);
            if (!solution.costs.contains(row.feature))
                errors.takenElsewhere.push_back({ solution.title(), grading.seed, row.name, row.message });
        }
        std::string missed;
        for (const Feature& feature : gradedFeatures) {
            const bool isWrong = solution.costs.contains(feature.name);
            if (isWrong && !failed.contains(feature.name))
                missed += (missed.empty() ? "" : ", ") + feature.name;
            errors.untouchedFeatures += !isWrong;
            errors.wronglyTouchedFeatures += !isWrong && failed.contains(feature.name);
        }
        if (!missed.empty())
            errors.falseAccepts.push_back(fmt::format("{} (all points for {})", solution.title(), missed));
    }

    void countAccepted(const Grading& grading, GraderErrors& errors)
    {
        for (const Row& row : grading.lost)
            errors.falseRejects.push_back({ grading.solution->title(), grading.seed, row.name, row.message });
        ++errors.acceptedGradings;
        errors.falselyRejectedGradings += !grading.lost.empty();
    }

}

GraderErrors validate(const Bank& bank, std::size_t acceptedGradings, uint64_t firstSeed,
    const std::shared_ptr<ExpectedAnswers>& expected, const OnProgress& onProgress)
{
    std::vector<Grading> gradings = gradingsOf(bank, acceptedGradings, firstSeed);
    std::atomic<std::size_t> begun = 0;
    tbb::parallel_for(std::size_t(0), gradings.size(), [&](std::size_t i) {
        onProgress(fmt::format("{} of {}: {}", ++begun, gradings.size(), gradings[i].solution->title()));
        // A thread that waits begins no other grading, which would write to the same folder.
        tbb::this_task_arena::isolate([&] { gradings[i].lost = lostRows(gradings[i], expected); });
    });
    GraderErrors errors;
    errors.wrongSolutions = bank.wrong.size();
    errors.acceptedSolutions = bank.accepted.size();
    for (const Grading& grading : gradings)
        grading.isWrong ? countWrong(grading, errors) : countAccepted(grading, errors);
    return errors;
}

}
