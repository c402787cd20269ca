#pragma once
#include <array>
#include <cstdint>

// What the probes of the sampler are asked, and answer. They count where the numbers are, for there are billions.
namespace stress {

// The first number of each of so many seeds.
struct Seeds {
    uint64_t first, count;
};

// So many numbers of one seed.
struct Stream {
    uint32_t seed;
    uint64_t count;
};

struct Counts {
    uint64_t outside = 0; // of [0, 1)
    uint64_t between = 0; // no multiple of 2^-24
    uint64_t sum = 0; // in units of 2^-24, exactly
    std::array<uint64_t, 256> cells {}; // equal parts of [0, 1)
};

// How many numbers of one seed are drawn until each of the 2^24 was seen; no more than most.
struct Coverage {
    uint32_t seed;
    uint64_t most;
};

struct Covered {
    uint64_t drawn = 0, seen = 0, outside = 0;
};

// Numbers of neighbouring pixels of a picture whose pixels' seeds are seedOffset + row * width + column.
struct Neighbours {
    uint32_t seedOffset;
    int width, height;
    int right, down; // to the neighbour
    int number, neighboursNumber; // which of a pixel's numbers, from 0
};

// Sums over all pairs of neighbours of what their numbers are above 1/2, and where pairs lie in the unit square.
struct Pairs {
    uint64_t count = 0;
    double product = 0.0;
    std::array<uint64_t, 256> cells {}; // 16 x 16
};

}
