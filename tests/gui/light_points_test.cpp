#include "gui/light_points.h"
#include "some_camera.h"
#include <catch2/catch.hpp>
#include <random>

// A point of a light that is dragged stays under the mouse, and nothing else moves.

namespace {

constexpr glm::ivec2 size { 320, 200 };
constexpr float fewRoundings = 1e-5f; // of numbers below 10
constexpr float rounding = 0.01f; // pixels: floats of a few hundred, rounded a dozen times

// One of each kind, around where someCamera looks.
std::vector<Scene::SceneLight> someLights()
{
    const glm::vec3 white { 1.0f };
    return { PointLight { { 0.5f, 0.1f, 0.2f }, white },
        SegmentLight { { -0.4f, 0.0f, 0.0f }, { 0.2f, 0.7f, 0.0f }, white, white },
        ParallelogramLight {
            { 0.0f, -0.6f, 0.1f }, { 0.7f, 0.1f, 0.0f }, { 0.0f, 0.2f, 0.6f }, white, white, white, white } };
}

}

TEST_CASE("A light's points are its position, its ends, or a corner and the two next to it", "[gui]")
{
    const auto lights = someLights();
    CHECK(gui::pointsOf(lights[0]) == std::vector { glm::vec3(0.5f, 0.1f, 0.2f) });
    CHECK(gui::pointsOf(lights[1]) == std::vector { glm::vec3(-0.4f, 0.0f, 0.0f), glm::vec3(0.2f, 0.7f, 0.0f) });
    const auto corners = gui::pointsOf(lights[2]);
    REQUIRE(corners.size() == 3);
    CHECK(corners[0] == glm::vec3(0.0f, -0.6f, 0.1f));
    CHECK(glm::distance(corners[1], glm::vec3(0.7f, -0.5f, 0.1f)) < fewRoundings);
    CHECK(glm::distance(corners[2], glm::vec3(0.0f, -0.4f, 0.7f)) < fewRoundings);
}

TEST_CASE("The lines of a parallelogram go once around it, through the corner opposite v0", "[gui]")
{
    const auto lights = someLights();
    CHECK(gui::linesOf(lights[0]).empty());
    CHECK(gui::linesOf(lights[1]).size() == 1);
    const auto edges = gui::linesOf(lights[2]);
    REQUIRE(edges.size() == 4);
    for (std::size_t i = 0; i < 4; ++i)
        CHECK(edges[i].second == edges[(i + 1) % 4].first);
    CHECK(glm::distance(edges[1].second, glm::vec3(0.7f, -0.3f, 0.7f)) < fewRoundings);
}

TEST_CASE("A point of a light that is moved is where it was moved to, and the others stay", "[gui]")
{
    const glm::vec3 target { 1.5f, -2.0f, 0.3f };
    for (const Scene::SceneLight& before : someLights()) {
        const auto places = gui::pointsOf(before);
        for (std::size_t moved = 0; moved < places.size(); ++moved) {
            Scene::SceneLight light = before;
            gui::movePoint(light, moved, target);
            const auto after = gui::pointsOf(light);
            for (std::size_t i = 0; i < places.size(); ++i)
                CHECK(glm::distance(after[i], i == moved ? target : places[i]) < fewRoundings);
        }
    }
}

TEST_CASE("The point under the mouse is the nearest that is shown within the radius", "[gui]")
{
    const auto lights = someLights();
    const debug::Projection projection { someCamera(), size };
    for (std::size_t light = 0; light < lights.size(); ++light)
        for (std::size_t point = 0; point < gui::pointsOf(lights[light]).size(); ++point) {
            const glm::vec2 shown = projection.point(gui::pointsOf(lights[light])[point]).value();
            const std::optional expected = gui::LightPoint { light, point };
            CHECK(gui::pointAt(lights, projection, shown + glm::vec2(2.0f, -2.0f), 5.0f) == expected);
            CHECK(gui::pointAt(lights, projection, shown, 1e4f) == expected); // all are within, this is nearest
        }
    CHECK_FALSE(gui::pointAt(lights, projection, { 1.0f, 1.0f }, 5.0f));
}

TEST_CASE("A light behind the camera has no point under the mouse", "[gui]")
{
    const Trackball camera = someCamera();
    const glm::vec3 behind = camera.position() - camera.forward();
    const std::vector<Scene::SceneLight> lights { PointLight { behind, glm::vec3(1.0f) } };
    CHECK_FALSE(gui::pointAt(lights, debug::Projection(camera, size), glm::vec2(size) * 0.5f, 1e4f));
}

TEST_CASE("What is at a place of the picture is shown there, and as far ahead as asked for", "[gui]")
{
    const Trackball camera = someCamera();
    const debug::Projection projection { camera, size };
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    for (int i = 0; i < 100; ++i) {
        const glm::vec2 place = glm::vec2(unit(random), unit(random)) * glm::vec2(size);
        const glm::vec3 asFarAs
            = camera.position() + (0.5f + 5.0f * unit(random)) * camera.forward() + unit(random) * camera.up();
        const glm::vec3 found = gui::positionAt(place, camera, size, asFarAs);
        CHECK(glm::distance(projection.point(found).value(), place) < rounding);
        CHECK(std::abs(glm::dot(found - asFarAs, camera.forward())) < fewRoundings);
    }
}
