#include "bench/measure.h"
#include "bench/ray_sets.h"
#include <catch2/catch.hpp>

// The naive tree and the binary one share no box test's order, no builder and no walk with the wide one.
TEST_CASE("Whoever takes part in the race finds the same hits", "[bench]")
{
    const bench::Model model = bench::loadModel("teapot");
    bench::Rivals rivals;
    bench::addWide(model.triangles, rivals);
    bench::addBinary(model.triangles, rivals);
    bench::addNaive(model.triangles, rivals);
    const accel::WideTree tree(model.triangles);
    const auto sets = bench::makeRaySets(model, tree, 2000);
    REQUIRE(sets.size() == 3);
    for (const bench::RaySet& set : sets) {
        const std::vector<bench::Time> times = bench::measure(set, rivals, 1);
        for (std::size_t i = 0; i < rivals.size(); ++i) {
            INFO(set.name << " rays, " << rivals[i]->name);
            CHECK(times[i].numDisagreeing == 0);
        }
    }
}
