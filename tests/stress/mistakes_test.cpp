#include "stressed.h"
#include <catch2/catch.hpp>

// Copies of the reference with one mistake each, of those that students make with numbers.

namespace {

struct Mistakes {
    std::string file;
    std::vector<std::string> names;
};

const Mistakes interpolation { "interpolate",
    {
        "areas without a sign",
        "coordinates turned by one corner",
        "half an area as integers",
        "outside clamped, so that the sum is not 1",
        "0 / 0 for a triangle without area",
        "0 / 0 on an edge of equal corners",
        "a triangle is without area below a fixed one",
        "normal not unit",
        "result of normalize dropped",
        "normal of a point on an edge refused",
    } };

const Mistakes tree { "bvh",
    {
        "a box is missed from inside",
        "a ray along the lower face of a box is NaN",
        "a ray along the upper face of a box is NaN",
        "numeric_limits::min() in place of minus infinity",
        "a flat box is never met",
        "a box's distance in lengths is compared to t",
        "a box test shortens the ray for good",
        "the first leaf with a hit wins",
        "the last hit is kept instead of the closest",
        "the incoming ray's t is ignored",
        "the hit is described by its leaf's last triangle",
        "the normal is turned only with shadows on",
    } };

const Mistakes rays { "recursive",
    {
        "reflected ray with no offset",
        "reflected ray offset by 1e-6",
        "reflected ray offset by 1e-2",
        "reflected origin from barycentrics",
        "mirrored about a normal that is not unit",
        "scalar added to all axes of the passthrough origin",
        "passthrough origin scaled",
        "passthrough ray with no offset",
        "passthrough ray offset by a few epsilon",
        "t of the passthrough ray 1",
    } };

// Few cases are enough: who makes such a mistake makes it often.
void expectCaught(const Mistakes& mistakes)
{
    const std::string name = GENERATE_COPY(from_range(mistakes.names));
    INFO(mistakes.file << ": " << name);
    const auto folder = changedReference(mistakes.file, mistakeNamed(mistakes.file, name).text);
    const Stressed stressed = stress(folder, "--cases 20000 --only " + mistakes.file);
    INFO(stressed.printed);
    CHECK(stressed.exitCode == 1);
    CHECK(stressed.failed(mistakes.file) > 0);
}

}

TEST_CASE("A mistake in interpolate.cpp fails cases of interpolation", "[stress]")
{
    expectCaught(interpolation);
}

TEST_CASE("A mistake in bvh.cpp fails cases of the tree", "[stress]")
{
    expectCaught(tree);
}

TEST_CASE("A mistake in recursive.cpp fails cases of the rays that follow", "[stress]")
{
    expectCaught(rays);
}
