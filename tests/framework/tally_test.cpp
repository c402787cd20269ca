#include "debug/tally.h"
#include "draw.h"
#include "intersect.h"
#include <catch2/catch.hpp>
#include <thread>

using debug::Tally;

namespace {

void testTriangle()
{
    Ray ray;
    HitInfo hitInfo;
    (void)intersectRayWithTriangle({ 0, 0, -1 }, { 1, 0, -1 }, { 0, 1, -1 }, ray, hitInfo);
}

}

TEST_CASE("A tally counts the triangles that are tested and the boxes that are drawn", "[tally]")
{
    testTriangle(); // nobody counts
    const Tally tally;
    CHECK(tally.numTriangles() == 0);
    testTriangle();
    testTriangle();
    drawAABB({});
    CHECK(tally.numTriangles() == 2);
    CHECK(tally.numNodes() == 1);
}

TEST_CASE("Of nested tallies the innermost counts, and none hears another thread", "[tally]")
{
    CHECK_FALSE(Tally::isOpen());
    {
        const Tally outer;
        {
            const Tally inner;
            testTriangle();
            CHECK(inner.numTriangles() == 1);
        }
        std::thread(testTriangle).join();
        CHECK(outer.numTriangles() == 0);
        testTriangle();
        CHECK(outer.numTriangles() == 1);
    }
    CHECK_FALSE(Tally::isOpen());
}
