#include "bench/frame_comparison.h"
#include <algorithm>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace bench {
namespace {

    using worker::Timing;

    constexpr double goalOfFrames = 0.6; // shading and all else may take two thirds of what the rays take
    constexpr double goalOfTwoThreads = 1.9;
    constexpr double goalOverBinary = 10.0; // where the tree is deep
    constexpr uint64_t manyTriangles = 15'000;

    double rate(const Timing& timing, double seconds)
    {
        return static_cast<double>(timing.numRays) * 1e-6 / seconds;
    }

    double bestRate(const Timing& timing)
    {
        return rate(timing, std::ranges::min(timing.seconds));
    }

    struct Contestant {
        std::string name;
        const Timing& timing;
    };

    // The speed alone: who it is of follows.
    Comparison comparison(const Contestant& ours, const Contestant& theirs, std::optional<double> goal = {})
    {
        Comparison result { .ours = ours.name, .theirs = theirs.name, .goal = goal };
        result.ourRate = bestRate(ours.timing);
        result.theirRate = bestRate(theirs.timing);
        result.ratio = result.ourRate / result.theirRate;
        std::vector<double> ratios;
        for (std::size_t i = 0; i < ours.timing.seconds.size(); ++i)
            ratios.push_back(rate(ours.timing, ours.timing.seconds[i]) / rate(theirs.timing, theirs.timing.seconds[i]));
        const auto [least, most] = std::ranges::minmax(ratios);
        result.leastRatio = least;
        result.mostRatio = most;
        return result;
    }

    std::string nameOfThreaded(const Timing& timing)
    {
        return fmt::format("{} threads", timing.numThreads);
    }

}

std::vector<Comparison> compare(const std::string& scene, const std::string& with, const worker::Speed& speed)
{
    const Contestant frame { "frame", speed.frame }, traversal { "traversal", speed.traversal };
    const auto overBinary = speed.numTriangles >= manyTriangles ? std::optional(goalOverBinary) : std::nullopt;
    std::vector<Comparison> all {
        comparison(frame, traversal, goalOfFrames),
        comparison({ "hits", speed.hits }, traversal),
        comparison(frame, { with + "'s frame", speed.theirFrame }, overBinary),
        comparison(traversal, { with + "'s hits", speed.theirHits }),
    };
    for (const Timing& timing : speed.threadedFrames)
        all.push_back(comparison({ nameOfThreaded(timing), timing }, frame,
            timing.numThreads == 2 ? std::optional(goalOfTwoThreads) : std::nullopt));
    for (Comparison& one : all) {
        one.scene = scene;
        one.numTriangles = speed.numTriangles;
    }
    return all;
}

nlohmann::json toJson(const std::vector<Comparison>& comparisons)
{
    nlohmann::json rows = nlohmann::json::array();
    for (const Comparison& c : comparisons) {
        rows.push_back({ { "scene", c.scene }, { "triangles", c.numTriangles }, { "ours", c.ours },
            { "theirs", c.theirs }, { "mrays_per_second", c.ourRate }, { "their_mrays_per_second", c.theirRate },
            { "ratio", c.ratio }, { "least_ratio", c.leastRatio }, { "most_ratio", c.mostRatio } });
        if (c.goal)
            rows.back()["goal"] = *c.goal;
    }
    return rows;
}

void printHeader()
{
    fmt::print("{:<24} {:>9}  {:<10} {:>6}  {:<18} {:>6}  {:<22}  goal\n", "scene", "triangles", "ours", "M/s",
        "theirs", "M/s", "ours over theirs");
}

void print(const Comparison& c)
{
    const std::string ratio = fmt::format("{:.2f} ({:.2f} to {:.2f})", c.ratio, c.leastRatio, c.mostRatio);
    fmt::print("{:<24} {:>9}  {:<10} {:>6.2f}  {:<18} {:>6.2f}  {:<22}  {}\n", c.scene, c.numTriangles, c.ours,
        c.ourRate, c.theirs, c.theirRate, ratio, c.goal ? fmt::format("{:g}", *c.goal) : "");
    std::fflush(stdout);
}

}
