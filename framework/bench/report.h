#pragma once
#include "bench/measure.h"
#include <nlohmann/json_fwd.hpp>

namespace bench {

// One rival on one set of rays of one model.
struct Row {
    std::string model, rays, rival;
    double megaraysPerSecond;
    double ratio, leastRatio, mostRatio; // ours (the first rival's) rate over this one's; of single repetitions
    double buildSeconds, bytesPerTriangle;
    std::size_t numDisagreeing;
};

// Rivals' names: the library's own traversals, and what they are to beat.
inline constexpr std::string_view ourNames[] = { "x86-64-v4", "x86-64-v3", "x86-64-v2", "baseline" };
inline constexpr std::string_view bestOfEmbree[] = { "Embree default", "Embree high" };

[[nodiscard]] std::vector<Row> makeRows(
    const Model& model, const RaySet& set, const Rivals& rivals, const std::vector<Time>& times);

// The geometric mean over all models of ours over theirs, for each kind of rays.
[[nodiscard]] nlohmann::json geometricMeans(const std::vector<Row>& rows);
[[nodiscard]] nlohmann::json toJson(const std::vector<Row>& rows);
// Throws std::invalid_argument, with what was found, for anything that toJson does not make.
[[nodiscard]] std::vector<Row> fromJson(const nlohmann::json& rows);

void print(const Row& row);

}
