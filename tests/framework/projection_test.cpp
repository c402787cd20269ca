#include "debug/projection.h"
#include <catch2/catch.hpp>
#include <glm/trigonometric.hpp>
#include <random>

// Where a drawing shows a point is where the camera sees it.

namespace {

constexpr glm::ivec2 size { 320, 200 };

Trackball someCamera(float rotation)
{
    Trackball camera { glm::radians(50.0f), 3.0f, 1.6f };
    camera.setCamera({ 0.1f, -0.2f, 0.3f }, { rotation, 2.0f * rotation, 0.5f * rotation }, 3.0f);
    return camera;
}

}

TEST_CASE("A point on the ray through a place of the screen is shown at that place", "[projection]")
{
    const Trackball camera = someCamera(GENERATE(0.0f, 0.7f, -2.0f));
    const debug::Projection projection { camera, size };
    std::mt19937 random(1);
    std::uniform_real_distribution<float> ndc(-1.5f, 1.5f), distance(0.1f, 50.0f);
    for (int i = 0; i < 200; ++i) {
        const glm::vec2 place { ndc(random), ndc(random) };
        const Ray ray = camera.generateRay(place);
        const auto shown = projection.point(ray.origin + distance(random) * ray.direction);
        REQUIRE(shown);
        const glm::vec2 expected = (0.5f * place + 0.5f) * glm::vec2(size);
        CHECK(glm::distance(*shown, expected) < 0.01f); // pixels: floats of a few hundred, rounded a dozen times
    }
}

TEST_CASE("What lies behind the camera is not shown, and a line into it ends in front", "[projection]")
{
    const Trackball camera = someCamera(0.4f);
    const debug::Projection projection { camera, size };
    const glm::vec3 behind = camera.position() - camera.forward() + 0.3f * camera.left();
    const glm::vec3 ahead = camera.position() + 2.0f * camera.forward();
    CHECK_FALSE(projection.point(behind));
    CHECK_FALSE(projection.line(behind, behind + camera.up()));
    CHECK(projection.ball(behind, 0.1f).empty());
    const auto line = projection.line(ahead, behind);
    REQUIRE(line);
    CHECK(glm::distance(line->first, glm::vec2(size) * 0.5f) < 0.01f);
    CHECK(line->second.x < line->first.x); // leftwards
    const auto reversed = projection.line(behind, ahead);
    REQUIRE(reversed);
    CHECK(reversed->first == line->second);
    CHECK(reversed->second == line->first);
}

TEST_CASE("A ball's outline lies around its centre, smaller with distance", "[projection]")
{
    const Trackball camera = someCamera(0.4f);
    const debug::Projection projection { camera, size };
    const auto widthAt = [&](float distance) {
        const auto outline = projection.ball(camera.position() + distance * camera.forward(), 0.1f);
        REQUIRE(outline.size() > 8);
        return outline[0].x - outline[outline.size() / 2].x;
    };
    CHECK(std::abs(widthAt(2.0f)) == Approx(2.0f * std::abs(widthAt(4.0f))).epsilon(1e-3));
}
