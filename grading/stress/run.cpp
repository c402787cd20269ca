#include "grading/stress/run.h"
#include "grading/stress/asker.h"
#include <algorithm>
#include <atomic>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>
#include <stdexcept>
#include <thread>

namespace stress {
namespace {

    // A message to a worker.
    struct Portion {
        const Stress* kind;
        Range range;
    };

    std::vector<const Stress*> kindsOf(const std::string& only)
    {
        std::vector<const Stress*> kinds;
        std::set<std::string> features;
        for (const Stress& kind : Stress::all()) {
            features.insert(kind.feature);
            if (only.empty() || kind.name == only || kind.name.starts_with(only + "."))
                kinds.push_back(&kind);
        }
        if (kinds.empty())
            throw std::invalid_argument(fmt::format(
                "--only {}: expected one of {}, or a name that begins so", only, fmt::join(features, ", ")));
        return kinds;
    }

    std::vector<Portion> theOne(const std::vector<const Stress*>& kinds, const std::string& only, std::size_t input)
    {
        const auto kind = std::ranges::find(kinds, only, &Stress::name);
        if (kind == kinds.end())
            throw std::invalid_argument(fmt::format("--case: expected --only with a whole name, such as {}, found {}",
                kinds.front()->name, only.empty() ? "none" : only));
        if (!(*kind)->isRandom() && input >= (*kind)->numInputs)
            throw std::invalid_argument(
                fmt::format("--case {}: {} has cases 0 to {}", input, only, (*kind)->numInputs - 1));
        return { { *kind, { input, 1 } } };
    }

    // How many times the usual number of random inputs.
    double shareOf(const std::vector<const Stress*>& kinds, std::optional<std::size_t> numCases)
    {
        std::size_t usual = 0;
        for (const Stress* const kind : kinds)
            usual += kind->isRandom() ? kind->numInputs * kind->casesEach : 0;
        return numCases && usual > 0 ? static_cast<double>(*numCases) / static_cast<double>(usual) : 1.0;
    }

    std::vector<Portion> portionsOf(const std::vector<const Stress*>& kinds, double share)
    {
        constexpr std::size_t mostCases = 16384; // in a message: a worker is asked seldom, and progress is seen
        std::vector<Portion> portions;
        for (const Stress* const kind : kinds) {
            const double wanted = kind->isRandom() ? std::ceil(share * static_cast<double>(kind->numInputs)) : 0.0;
            const std::size_t count = kind->isRandom() ? static_cast<std::size_t>(wanted) : kind->numInputs;
            const std::size_t most = std::max<std::size_t>(1, mostCases / kind->casesEach);
            for (std::size_t first = 0; first < count; first += most)
                portions.push_back({ kind, { first, std::min(most, count - first) } });
        }
        return portions;
    }

    std::vector<Portion> portionsOf(const Plan& plan)
    {
        const auto kinds = kindsOf(plan.only);
        return plan.input ? theOne(kinds, plan.only, *plan.input) : portionsOf(kinds, shareOf(kinds, plan.numCases));
    }

    // What threads share: they take one portion after the other.
    struct Work {
        std::vector<Portion> portions;
        Tallies tallies {};
        std::atomic<std::size_t> next = 0, numDone = 0;
        std::exception_ptr error {}; // of our own, the first
        std::mutex mutex {};
    };

    void askInTurn(Work& work, const Plan& plan, Asker asker, const std::function<void(float)>& onProgress)
    {
        try {
            for (std::size_t i; (i = work.next++) < work.portions.size();) {
                const auto& [kind, range] = work.portions[i];
                Tally& tally = work.tallies.at(kind);
                asker.ask(*kind, range, tally);
                if (plan.stopsWhenGivenUp && tally.isGivenUp())
                    work.next = work.portions.size();
                if (onProgress)
                    onProgress(static_cast<float>(++work.numDone) / static_cast<float>(work.portions.size()));
            }
        } catch (...) {
            const std::lock_guard lock(work.mutex);
            work.error = std::current_exception();
            work.next = work.portions.size();
        }
    }

}

Tallies run(const std::filesystem::path& worker, const Plan& plan, const std::function<void(float)>& onProgress)
{
    Work work { portionsOf(plan) };
    for (const Portion& portion : work.portions)
        work.tallies[portion.kind];
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
        threads.emplace_back(
            askInTurn, std::ref(work), std::cref(plan), Asker(worker, plan.seed, plan.patience), std::cref(onProgress));
    for (std::thread& thread : threads)
        thread.join();
    if (work.error)
        std::rethrow_exception(work.error);
    return std::move(work.tallies);
}

}
