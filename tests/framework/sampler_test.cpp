#include "grading/chi_square.h"
#include "sampler.h"
#include <catch2/catch.hpp>
#include <set>
#include <vector>

namespace {

// A fair sampler is further off than this with a probability of 6e-7 for each seed, and the seeds are fixed.
constexpr double fiveDeviations = 5.0;

constexpr int cells = 16;

std::size_t cellOf(float x)
{
    return static_cast<std::size_t>(x * cells);
}

std::size_t cellOf(float x, float y)
{
    return cellOf(x) * cells + cellOf(y);
}

}

TEST_CASE("Random numbers are 0 or more and less than 1", "[sampler]")
{
    Sampler sampler(1);
    float least = 1.0f, greatest = 0.0f;
    for (int i = 0; i < 10'000'000; ++i) {
        const float x = sampler.next_1d();
        least = std::min(least, x);
        greatest = std::max(greatest, x);
    }
    CHECK(least >= 0.0f);
    CHECK(greatest < 1.0f);
    CHECK(least < 1e-5f); // all of ten million above: a probability of 4e-44
    CHECK(greatest > 1.0f - 1e-5f);
}

TEST_CASE("Equal seeds give equal streams, other seeds others", "[sampler]")
{
    Sampler a(5), b(5), c(6);
    bool differ = false;
    for (int i = 0; i < 1000; ++i) {
        const glm::vec2 fromA = a.next_2d();
        CHECK(fromA == b.next_2d());
        differ |= fromA != c.next_2d();
    }
    CHECK(differ);
    CHECK(Sampler().next_2d() != Sampler().next_2d()); // without a seed: once in 2^32
}

TEST_CASE("next_2d is two numbers of the stream, x first", "[sampler]")
{
    Sampler a(5), b(5);
    const glm::vec2 both = a.next_2d();
    CHECK(both.x == b.next_1d());
    CHECK(both.y == b.next_1d());
}

TEST_CASE("Numbers of a stream, and neighbours in it, are spread evenly", "[sampler]")
{
    for (uint32_t seed = 0; seed < 10; ++seed) {
        Sampler sampler(seed);
        std::vector<int> single(cells), pairs(cells * cells);
        for (int i = 0; i < 100'000; ++i) {
            const glm::vec2 xy = sampler.next_2d();
            ++single[cellOf(xy.x)];
            ++pairs[cellOf(xy.x, xy.y)];
        }
        CHECK(std::abs(grading::unevenness(single)) < fiveDeviations);
        CHECK(std::abs(grading::unevenness(pairs)) < fiveDeviations);
    }
}

TEST_CASE("Neighbouring seeds, which neighbouring pixels have, give independent numbers", "[sampler]")
{
    for (const uint32_t stride : { 1u, 2u, 800u, 1u << 15 }) { // no seed comes twice
        std::vector<int> first(cells), pairs(cells * cells), planes(cells * cells);
        for (uint32_t i = 0; i < 100'000; ++i) {
            Sampler here(i * stride), next((i + 1) * stride);
            const glm::vec2 mine = here.next_2d(), theirs = next.next_2d();
            ++first[cellOf(mine.x)];
            ++pairs[cellOf(mine.x, theirs.x)];
            ++planes[cellOf(mine.x, mine.y)];
        }
        CHECK(std::abs(grading::unevenness(first)) < fiveDeviations);
        CHECK(std::abs(grading::unevenness(pairs)) < fiveDeviations);
        CHECK(std::abs(grading::unevenness(planes)) < fiveDeviations);
    }
}

TEST_CASE("No two of a large picture's pixels have the same numbers", "[sampler]")
{
    std::set<std::pair<float, float>> seen;
    constexpr uint32_t count = 100'000;
    for (uint32_t seed = 0; seed < count; ++seed) {
        const glm::vec2 xy = Sampler(seed).next_2d();
        seen.emplace(xy.x, xy.y);
    }
    CHECK(seen.size() >= count - 1); // of 2^48 pairs, two are the same with a probability of 2e-5
}
