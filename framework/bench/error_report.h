#pragma once
#include "bench/error_curve.h"
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace bench {

// What a strategy errs on one integrand.
struct ErrorCurve {
    std::string integrand, strategy;
    std::vector<ErrorPoint> points; // by number of samples
    Slope slope; // of 16 samples and more: fewer are no pattern yet
    Gain at64;
    double theory; // the slope that it should have
};

void printErrorHeader();
void print(const ErrorCurve& curve);

// How long each takes to reach some errors.
void printTimes(const std::vector<ErrorCurve>& curves);

// "slope" and "gain_at_64" by integrand and strategy, and more like them; all of it for pairs of numbers by themselves.
[[nodiscard]] nlohmann::json toJson(const std::vector<ErrorCurve>& curves);

// Error against samples and against time, as error_by_samples and error_by_time of the folder.
void plot(const std::vector<ErrorCurve>& curves, const std::filesystem::path& folder);

}
