#pragma once
#include "bench/ray_sets.h"
#include "bench/rival.h"

namespace bench {

// What it took a rival to trace a set of rays.
struct Time {
    double seconds = 0.0; // the sum of each chunk's shortest time
    std::vector<double> repetitions; // the sums of all chunks' times, one a repetition
    std::size_t numDisagreeing = 0; // answers other than the first rival's
};

// One a rival. Chunks of rays go to all in turn, each time in another order, so that what else the machine does meets
// all alike.
[[nodiscard]] std::vector<Time> measure(const RaySet& set, const Rivals& rivals, int numRepetitions);

}
