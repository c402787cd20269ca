#include "stressed.h"
#include <catch2/catch.hpp>

// Copies of the reference with one mistake each, of those that students make with numbers.

namespace {

struct Mistake {
    std::string file, name;
};

const std::vector<Mistake> geometry {
    { "interpolate", "areas without a sign" },
    { "interpolate", "areas seen along z" },
    { "interpolate", "coordinates turned by one corner" },
    { "interpolate", "half an area as integers" },
    { "interpolate", "outside clamped, so that the sum is not 1" },
    { "interpolate", "edges do not belong to the triangle" },
    { "interpolate", "0 / 0 for a triangle without area" },
    { "interpolate", "0 / 0 on an edge of equal corners" },
    { "interpolate", "a triangle is without area below a fixed one" },
    { "interpolate", "normal not unit" },
    { "interpolate", "result of normalize dropped" },
    { "interpolate", "normal of a point on an edge refused" },
    { "bvh", "a box is missed from inside" },
    { "bvh", "a ray along the lower face of a box is NaN" },
    { "bvh", "a ray along the upper face of a box is NaN" },
    { "bvh", "the inverse of minus zero is minus infinity" },
    { "bvh", "numeric_limits::min() in place of minus infinity" },
    { "bvh", "a flat box is never met" },
    { "bvh", "a box's distance in lengths is compared to t" },
    { "bvh", "a box test shortens the ray for good" },
    { "bvh", "the first leaf with a hit wins" },
    { "bvh", "the last hit is kept instead of the closest" },
    { "bvh", "the incoming ray's t is ignored" },
    { "bvh", "the hit is described by its leaf's last triangle" },
    { "bvh", "the normal is turned only with shadows on" },
    { "bvh", "the flat normal is not unit" },
    { "recursive", "reflected ray with no offset" },
    { "recursive", "reflected ray offset by 1e-6" },
    { "recursive", "reflected ray offset by 1e-2" },
    { "recursive", "reflected origin from barycentrics" },
    { "recursive", "mirrored about a normal that is not unit" },
    { "recursive", "scalar added to all axes of the passthrough origin" },
    { "recursive", "passthrough origin scaled" },
    { "recursive", "passthrough ray offset by a few epsilon" },
    { "recursive", "t of the passthrough ray left as it came" },
};

}

TEST_CASE("A mistake of geometry fails cases of its own feature", "[stress]")
{
    const Mistake mistake = GENERATE(from_range(geometry));
    INFO(mistake.file << ": " << mistake.name);
    const auto folder = changedReference(mistake.file, mistakeNamed(mistake.file, mistake.name).text);
    const Stressed stressed = stress(folder, "--cases 20000 --only " + mistake.file);
    INFO(stressed.printed);
    CHECK(stressed.exitCode == 1);
    CHECK(stressed.failed(mistake.file) > 0);
}
