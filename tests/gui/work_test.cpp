#include "changed_reference.h"
#include "opened_window.h"
#include <algorithm>
#include <catch2/catch.hpp>

// What is done for a picture, told in the window while somebody asks.

using tests::OpenedWindow;

namespace {

const tests::Control count { { "count" }, "profiler" };

}

TEST_CASE("What is done for a picture is counted while that is asked for, and no longer", "[window]")
{
    OpenedWindow window { tests::cornell, tests::reference };
    window.drawUntilTraced();
    const gui::Picture plain = window.application.picture();
    CHECK(plain.work.rays.camera > 0);
    CHECK(plain.work.rays.unlit > 0);
    CHECK(plain.work.numTriangles == 0);
    CHECK(plain.needs.empty());

    window.activate(count);
    window.drawUntil([&] { return window.application.isPictureDone() && !window.application.picture().needs.empty(); });
    const gui::Picture& counted = window.application.picture();
    CHECK(counted.work.rays.camera == plain.work.rays.camera);
    CHECK(counted.work.rays.bounced == plain.work.rays.bounced);
    CHECK(counted.work.rays.unlit == plain.work.rays.unlit);
    CHECK(counted.work.numTriangles > 0);
    const auto why = [&](const std::string& part) {
        return std::ranges::find(counted.needs, part, &worker::ExplainedPart::name)->whyNot;
    };
    CHECK(why("spheres") == "the scene has none");
    CHECK(why("triangles").empty());

    window.activate(count);
    window.drawUntil([&] { return window.application.isPictureDone() && window.application.picture().needs.empty(); });
    CHECK(window.application.picture().work.numTriangles == 0);
}
