#pragma once
#include "bench/report.h"
#include <filesystem>

namespace bench {

// How many times as fast as the better of Embree's default and high quality we were, in the same run: on another day
// the rates are others, and the ratio is the same.
struct Lead {
    double ratio, least, most; // of all repetitions, and what it may be by their spread
};

// The lead of one of our traversals on one set of rays, in two runs.
struct Change {
    std::string model, rays, rival;
    Lead then, now;

    [[nodiscard]] double relative() const { return now.ratio / then.ratio - 1.0; }
};

// Of all rows of ours that both runs have, in the order of now.
[[nodiscard]] std::vector<Change> compare(const std::vector<Row>& then, const std::vector<Row>& now);

// Whether we fell back by more than the spread of both runs and more than the tolerance, which is a fraction.
[[nodiscard]] bool isRegression(const Change& change, double tolerance);

// What an earlier run wrote. Throws files::Error.
[[nodiscard]] std::vector<Row> readRows(const std::filesystem::path& file);

void print(const std::vector<Change>& changes, double tolerance);

}
