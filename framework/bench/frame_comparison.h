#pragma once
#include "worker/speed.h"
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace bench {

// Two ways to render a scene, or to answer its rays, side by side.
struct Comparison {
    std::string scene, ours, theirs;
    uint64_t numTriangles;
    double ourRate, theirRate; // million rays a second, each in its shortest time
    double ratio, leastRatio, mostRatio; // ours over theirs; of single repetitions
    std::optional<double> goal; // what the ratio should reach
};

// with: whose code.
[[nodiscard]] std::vector<Comparison> compare(
    const std::string& scene, const std::string& with, const worker::Speed& speed);

[[nodiscard]] nlohmann::json toJson(const std::vector<Comparison>& comparisons);

void printHeader();
void print(const Comparison& comparison);

}
