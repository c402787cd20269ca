#include "bench/traversal.h"
#include "app/run_command.h"
#include "bench/compare.h"
#include "bench/model_names.h"
#include "files/error.h"
#include "files/text.h"
#include "worker/process.h"
#include <nlohmann/json.hpp>

namespace bench {
namespace {

    struct Options {
        ModelNames models;
        std::string json, compare;
        std::string with = "reference";
        double tolerance = 5.0; // percent
        std::size_t numRays = 1 << 17;
        int numRepetitions = 5;
        bool onlyFast = false;
    };

    std::vector<Row> measureModel(const Model& model, const Options& options)
    {
        Rivals rivals;
        addWide(model.triangles, rivals);
        addEmbree(model.triangles, rivals);
        if (!options.onlyFast) {
            addBinary(model.triangles, rivals);
            addSubmission(options.with, model.triangles, rivals);
            addNaive(model.triangles, rivals);
        }

        std::vector<Row> rows;
        const accel::WideTree tree(model.triangles);
        for (const RaySet& set : makeRaySets(model, tree, options.numRays))
            for (const Row& row : makeRows(model, set, rivals, measure(set, rivals, options.numRepetitions))) {
                print(row);
                rows.push_back(row);
            }
        return rows;
    }

    std::vector<Row> measureAll(const Options& options)
    {
        fmt::print("{:<20} {:<8} {:<15} {:>7}  ours over it            build s  B/tri  disagree\n", "model", "rays",
            "rival", "M/s");
        std::vector<Row> rows;
        for (const Model& model : loadModels(options.models)) {
            const std::vector<Row> more = measureModel(model, options);
            rows.insert(rows.end(), more.begin(), more.end());
        }
        return rows;
    }

    constexpr int slower = 1; // an exit code

    int compareWith(const std::vector<Row>& then, const std::vector<Row>& now, const Options& options)
    {
        const double tolerance = options.tolerance / 100.0;
        const std::vector<Change> changes = compare(then, now);
        if (changes.empty())
            throw files::Error(options.compare, "found no traversal beside Embree's that was measured now, too");
        print(changes, tolerance);
        const bool isSlower
            = std::ranges::any_of(changes, [&](const Change& change) { return isRegression(change, tolerance); });
        return isSlower ? slower : app::Success;
    }

    int measureAndCompare(const Options& options)
    {
        const std::vector<Row> then = options.compare.empty() ? std::vector<Row>() : readRows(options.compare);
        const std::vector<Row> rows = measureAll(options);
        const nlohmann::json report { { "rows", toJson(rows) }, { "geomean", geometricMeans(rows) } };
        fmt::print("{}\n", report["geomean"].dump());
        if (!options.json.empty())
            files::writeText(options.json, report.dump(2) + "\n");
        return options.compare.empty() ? app::Success : compareWith(then, rows, options);
    }

    int run(const Options& options)
    {
        try {
            return measureAndCompare(options);
        } catch (const worker::Failure& failure) {
            fmt::print(stderr, "the code of {} failed: {}\n", options.with, failure.what());
            return app::SubmissionFailed;
        }
    }

}

Command declareTraversal(CLI::App& cli)
{
    const auto options = std::make_shared<Options>();
    CLI::App& command = *cli.add_subcommand("traversal", "One ray after the other through a tree, on one thread");
    declareModels(command, options->models);
    command.add_option("--json", options->json, "Write the figures to this file");
    command.add_option("--compare", options->compare, "Tell what became slower since this file was written by --json");
    command.add_option("--tolerance", options->tolerance, "Percent that may be lost")
        ->capture_default_str()
        ->check(CLI::Range(0.0, 100.0));
    command.add_option("--rays", options->numRays, "Rays in a set")->capture_default_str()->check(CLI::PositiveNumber);
    command.add_option("--repetitions", options->numRepetitions, "Times that each ray is traced")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    command.add_option("--with", options->with, "Whose BVH::intersect: student, reference, or a submission's folder")
        ->capture_default_str();
    command.add_flag("--only-fast", options->onlyFast, "Leave out those that take ten times as long");
    command.footer("Exit codes: 0 done, 1 slower than what it is compared with, 2 bad input, "
                   "70 the submission's code failed.");
    return { &command, [options] { return run(*options); } };
}

}
