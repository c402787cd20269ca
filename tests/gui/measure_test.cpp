#include "changed_reference.h"
#include "opened_window.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <fmt/core.h>

// How fast the window answers: gui_tests [.measure] prints it. It is asked for by hand, on a machine that has nothing
// else to do.

using Clock = std::chrono::steady_clock;

static double millisecondsSince(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

static double medianOf(std::vector<double> values)
{
    std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
    return values[values.size() / 2];
}

TEST_CASE("Milliseconds from a turn of the camera to the first picture, and frames a second meanwhile", "[.measure]")
{
    const std::string scene = GENERATE("cornell_box", "teapot", "dragon", "soft_shadows");
    tests::OpenedWindow window { tests::source / "scenes" / (scene + ".toml"), tests::reference };
    window.drawUntilTraced();
    std::vector<double> first, frames;
    for (int i = 0; i < 21; ++i) {
        window.application.document().settings.config.camera.rotation.y += 3.0f;
        const auto start = Clock::now();
        window.drawFrames(1); // asks for it
        window.drawUntil([&] { return window.application.isPictureCurrent(); });
        first.push_back(millisecondsSince(start));
        while (!window.application.isPictureDone()) {
            const auto frame = Clock::now();
            window.drawFrames(1);
            frames.push_back(millisecondsSince(frame));
        }
    }
    fmt::print("{}: first picture after {:.0f} ms (median; longest {:.0f}), a frame while tracing {:.1f} ms (median; "
               "longest {:.1f})\n",
        scene, medianOf(first), std::ranges::max(first), medianOf(frames), std::ranges::max(frames));
    CHECK(!frames.empty());
    window.pressKey("t");
    std::vector<double> rasterised;
    for (int i = 0; i < 100; ++i) {
        window.application.document().settings.config.camera.rotation.y += 3.0f;
        const auto frame = Clock::now();
        window.drawFrames(1);
        rasterised.push_back(millisecondsSince(frame));
    }
    fmt::print("{}: a rasterised frame {:.1f} ms (median)\n", scene, medianOf(rasterised));
}

TEST_CASE("Frames a second while the submission prints without end", "[.measure]")
{
    const tests::ChangedReference folder { "light.cpp", R"(
#include "light.h"
#include <cstdio>
glm::vec3 computeContributionPointLight(RenderState&, const PointLight&, const Ray&, const HitInfo&)
{
    for (int i = 0; i < 100'000'000; ++i)
        std::printf("line %d\n", i);
    return {};
}
)" };
    tests::OpenedWindow window { tests::cornell, folder.path() };
    window.drawUntil([&] { return window.application.printed().lines().size() == gui::OutputLines::most; });
    std::vector<double> frames;
    for (int i = 0; i < 200; ++i) {
        const auto start = Clock::now();
        window.drawFrames(1);
        frames.push_back(millisecondsSince(start));
    }
    fmt::print("a flood: a frame {:.1f} ms (median; longest {:.1f})\n", medianOf(frames), std::ranges::max(frames));
    CHECK(window.application.printed().lines().size() == gui::OutputLines::most);
}
