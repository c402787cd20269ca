#pragma once
#include "grading/stress/tally.h"
#include <chrono>
#include <filesystem>
#include <map>
#include <optional>

namespace stress {

// What is wanted.
struct Plan {
    std::string only; // a feature, or a name or how it begins up to a dot; empty: all
    uint64_t seed = 1;
    std::optional<std::size_t> numCases; // random ones, about, in all; otherwise what each kind says
    std::chrono::seconds patience { 20 }; // with a message; one that asks for all numbers of a sampler takes seconds
    bool stopsWhenGivenUp = false; // asks no more of any kind once one has taken too many workers with it
    std::optional<std::size_t> input; // this one alone, of the one kind that `only` names
};

using Tallies = std::map<const Stress*, Tally>;

// Asks a worker, several kinds side by side. Calls onProgress(fraction of the inputs asked) from any thread. Throws
// std::invalid_argument when the plan names nothing.
[[nodiscard]] Tallies run(
    const std::filesystem::path& worker, const Plan& plan, const std::function<void(float)>& onProgress = {});

}
