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

[[nodiscard]] std::vector<Row> makeRows(
    const Model& model, const RaySet& set, const Rivals& rivals, const std::vector<Time>& times);

// The geometric mean over all models of ours over theirs, for each kind of rays.
[[nodiscard]] nlohmann::json geometricMeans(const std::vector<Row>& rows);
[[nodiscard]] nlohmann::json toJson(const std::vector<Row>& rows);

void print(const Row& row);

}
