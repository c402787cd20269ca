#include "values/owen_sobol.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

using values::owenSobol;

namespace {

// How many of 2^k points from first on lie in each box of 2^-a by 2^(a-k).
std::vector<int> countInBoxes(uint32_t first, int k, int a, uint32_t seed)
{
    std::vector<int> counts(std::size_t(1) << k);
    for (uint32_t i = first; i < first + (1u << k); ++i) {
        const glm::vec2 point = owenSobol(i, seed);
        const auto column = static_cast<std::size_t>(point.x * static_cast<float>(1 << a));
        const auto row = static_cast<std::size_t>(point.y * static_cast<float>(1 << (k - a)));
        ++counts.at(column << (k - a) | row);
    }
    return counts;
}

}

TEST_CASE("Owen's points, a power of two of them in a row has one in each elementary box", "[sampling]")
{
    for (const uint32_t seed : { 0u, 1u, 77u, 0xffffffffu })
        for (int k = 1; k <= 10; ++k)
            for (const uint32_t block : { 0u, 1u, 5u })
                for (int a = 0; a <= k; ++a)
                    REQUIRE(countInBoxes(block << k, k, a, seed) == std::vector<int>(std::size_t(1) << k, 1));
}

TEST_CASE("Owen's points, so have many of them", "[sampling]")
{
    constexpr int k = 18; // beyond half of an index's digits
    for (const int a : { 3, 9, 17 })
        REQUIRE(std::ranges::count(countInBoxes(0, k, a, 1), 1) == 1 << k);
}

TEST_CASE("Owen's points, other seeds give others, and other orders", "[sampling]")
{
    int numSame = 0;
    for (uint32_t seed = 1; seed <= 1000; ++seed)
        numSame += owenSobol(5, seed) == owenSobol(5, 0);
    CHECK(numSame == 0); // of 2^48 points
}

TEST_CASE("Owen's points, each on its own is uniform over seeds", "[sampling]")
{
    constexpr int side = 8, numSeeds = 64 * 1000;
    for (const uint32_t index : { 0u, 1u, 12345u }) {
        std::vector<int> counts(side * side);
        for (uint32_t seed = 0; seed < numSeeds; ++seed) {
            const glm::ivec2 cell(owenSobol(index, seed) * static_cast<float>(side));
            ++counts.at(static_cast<std::size_t>(cell.y * side + cell.x));
        }
        double chiSquare = 0.0;
        for (const int count : counts)
            chiSquare += (count - 1000.0) * (count - 1000.0) / 1000.0;
        CHECK(chiSquare < 132.0); // 63 degrees of freedom: exceeded once in 1e6 by chance, and the seeds are fixed
    }
}
