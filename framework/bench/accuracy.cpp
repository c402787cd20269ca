#include "bench/accuracy.h"
#include "accel/wide/tree.h"
#include "app/run_command.h"
#include "bench/exact_hits.h"
#include "bench/model_names.h"
#include "bench/ray_sets.h"
#include <fmt/core.h>
#include <tbb/parallel_for.h>

namespace bench {
namespace {

    struct Options {
        ModelNames models;
        std::size_t numRays = 1000;
    };

    struct Counts {
        std::size_t exact = 0, ties = 0, wrong = 0;

        void add(Verdict verdict) { ++(verdict == Verdict::Exact ? exact : verdict == Verdict::Tie ? ties : wrong); }
    };

    // By each kernel.
    std::vector<Verdict> judge(const Model& model, const accel::WideTree& tree, Question question, const Ray& ray)
    {
        const ExactHits exact(model.triangles, ray);
        std::vector<Verdict> verdicts;
        for (const accel::wide::Kernel* kernel : accel::wide::kernels())
            verdicts.push_back(question == Question::Closest ? exact.judge(tree.closest(ray, *kernel))
                                                             : exact.judge(tree.occluded(ray, *kernel)));
        return verdicts;
    }

    std::vector<Counts> count(const Model& model, const accel::WideTree& tree, const RaySet& set)
    {
        std::vector<std::vector<Verdict>> verdicts(set.rays.size());
        tbb::parallel_for(std::size_t { 0 }, set.rays.size(),
            [&](std::size_t i) { verdicts[i] = judge(model, tree, set.question, set.rays[i]); });
        std::vector<Counts> counts(accel::wide::kernels().size());
        for (const auto& ofRay : verdicts)
            for (std::size_t i = 0; i < ofRay.size(); ++i)
                counts[i].add(ofRay[i]);
        return counts;
    }

    constexpr int anyWrong = 1; // an exit code

    int run(const Options& options)
    {
        fmt::print("{:<20} {:<8} {:<10} {:>7} {:>6} {:>6}\n", "model", "rays", "ours", "exact", "ties", "wrong");
        std::size_t numWrong = 0;
        for (const Model& model : loadModels(options.models)) {
            const accel::WideTree tree(model.triangles);
            for (const RaySet& set : makeRaySets(model, tree, options.numRays)) {
                const std::vector<Counts> counts = count(model, tree, set);
                for (std::size_t i = 0; i < counts.size(); ++i) {
                    const auto& [exact, ties, wrong] = counts[i];
                    fmt::print("{:<20} {:<8} {:<10} {:>7} {:>6} {:>6}\n", model.name, set.name,
                        accel::wide::kernels()[i]->name, exact, ties, wrong);
                    numWrong += wrong;
                }
            }
        }
        return numWrong == 0 ? app::Success : anyWrong;
    }

}

Command declareAccuracy(CLI::App& cli)
{
    const auto options = std::make_shared<Options>();
    CLI::App& command
        = *cli.add_subcommand("accuracy", "What is found, against a search of all triangles in double precision");
    declareModels(command, options->models);
    command.add_option("--rays", options->numRays, "Rays in a set")->capture_default_str()->check(CLI::PositiveNumber);
    command.footer("Exit codes: 0 done, 1 an answer is wrong, 2 bad input.");
    return { &command, [options] { return run(*options); } };
}

}
