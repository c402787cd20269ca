#pragma once
#include "grading/stress/run.h"

namespace stress {

// What became of all that was asked, ready to be told.
struct Report {
    std::string submission; // as the user named it
    std::string alone; // the file that was asked beside the reference's others; empty: all files together
    uint64_t seed = 1;
    double seconds = 0.0;
    const Tallies& tallies;
};

[[nodiscard]] bool allPassed(const Report& report);

// The line that asks the one input of a failure again.
[[nodiscard]] std::string reproduction(const Report& report, const Stress& kind, const Failure& failure);

// A failure in lines: what was asked, what came, what was expected, and how to ask again.
[[nodiscard]] std::string paragraph(const Report& report, const Stress& kind, const Failure& failure);

// What a terminal shows: a row for each kind, and every failure that was kept.
[[nodiscard]] std::string table(const Report& report);

[[nodiscard]] std::string json(const Report& report);

}
