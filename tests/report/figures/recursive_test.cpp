#include "report/figures/drawn.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

using namespace report_test;
using report::Drawing;
using report::Picture;
using report::Slider;

namespace {

// An upright rectangle of a scene, as its camera sees it.
struct Seen {
    Seen(const debug::Projection& projection, const glm::vec3& corner, const glm::vec3& opposite)
    {
        const glm::vec2 a = projection.point(corner).value(), b = projection.point(opposite).value();
        lower = glm::min(a, b);
        upper = glm::max(a, b);
    }

    [[nodiscard]] bool contains(const glm::vec2& point, float margin) const
    {
        return glm::all(glm::greaterThan(point, lower + margin)) && glm::all(glm::lessThan(point, upper - margin));
    }

    glm::vec2 lower, upper;
};

std::size_t countStrokes(const Drawing& drawing, const glm::vec3& color)
{
    return static_cast<std::size_t>(std::ranges::count(drawing.strokes, color, &debug::Stroke::color));
}

}

TEST_CASE("With reflections the mirrors change and what is none of them does not", "[report]")
{
    const auto sheet = drawn("reflection.on_and_off");
    CHECK(brokenClaim(sheet) == "");
    const auto& [before, after] = panelOf<Slider>(sheet, 0);
    const auto projection = projectionOf("spheres", after.size);
    const auto centre = [&](const glm::vec3& position) {
        const glm::ivec2 pixel { projection.point(position).value() };
        return static_cast<std::size_t>(pixel.y * after.size.x + pixel.x);
    };
    for (const std::size_t mirror : { centre({ 0.1f, 0.55f, 1.3f }), centre({ -1.6f, 0, 0.5f }) })
        CHECK(before.pixels[mirror] != after.pixels[mirror]);
    for (const std::size_t dull : { centre({ 1.5f, 0, 0.4f }), centre({ -0.8f, -0.15f, -0.7f }), std::size_t(0) })
        CHECK(before.pixels[dull] == after.pixels[dull]);
}

TEST_CASE("The reflected ray is drawn in green from the foot of the yellow normal, at equal angles", "[report]")
{
    const auto sheet = drawn("reflection.debug");
    CHECK(brokenClaim(sheet) == "");
    const auto& drawing = panelOf<Drawing>(sheet, 0);
    const auto start = [&](const glm::vec3& color) {
        return std::ranges::find(drawing.strokes, color, &debug::Stroke::color)->points.front();
    };
    const glm::vec3 yellow { 1, 1, 0 }, green { 0, 1, 0 }, red { 1, 0, 0 };
    REQUIRE(countStrokes(drawing, yellow) == 1);
    REQUIRE(countStrokes(drawing, green) == 1);
    CHECK(countStrokes(drawing, red) == 2); // a light seen from the mirror and from what it shows
    CHECK(glm::distance(start(yellow), start(green)) < 0.01f); // pixels
    CHECK(sheet.data["in"].get<double>() == Approx(sheet.data["out"].get<double>()).margin(0.01)); // degrees, in float
    CHECK(sheet.data["in"].get<double>() > 20.0); // otherwise nobody sees that they are equal
}

TEST_CASE("From depth to depth pictures only gain light, and come closer to the deepest", "[report]")
{
    const auto sheet = drawn("reflection.depth");
    CHECK(brokenClaim(sheet) == "");
    REQUIRE(sheet.panels.size() == 8);
    double lastDistance = INFINITY;
    const Picture& deepest = panelOf<Picture>(sheet, 6);
    for (std::size_t depth = 0; depth < 6; ++depth) {
        const Picture &one = panelOf<Picture>(sheet, depth), &next = panelOf<Picture>(sheet, depth + 1);
        double distance = 0.0;
        bool gains = true;
        for (std::size_t i = 0; i < one.pixels.size(); ++i) {
            gains &= glm::all(glm::lessThanEqual(one.pixels[i], next.pixels[i]));
            distance += glm::distance(one.pixels[i], deepest.pixels[i]);
        }
        CHECK(gains);
        CHECK(distance < lastDistance);
        CHECK(distance > 0.0);
        lastDistance = distance;
    }
}

TEST_CASE("With transparency just the panes change", "[report]")
{
    const auto sheet = drawn("transparency.on_and_off");
    CHECK(brokenClaim(sheet) == "");
    const auto& [before, after] = panelOf<Slider>(sheet, 0);
    const auto projection = projectionOf("transparency", after.size);
    const Seen panes[] { { projection, { 1.3f, -0.2f, -0.6f }, { -0.5f, 1, -0.6f } },
        { projection, { 0.5f, -0.4f, -0.4f }, { -1.3f, 0.8f, -0.4f } },
        { projection, { 0.9f, -1, -0.2f }, { -0.9f, 0.3f, -0.2f } } };
    std::size_t unchanged = 0, changed = 0;
    forEachPixel(after.size, [&](glm::ivec2 pixel, std::size_t i) {
        const auto isIn = [&](float margin) {
            return std::ranges::any_of(
                panes, [&](const Seen& pane) { return pane.contains(glm::vec2(pixel) + 0.5f, margin); });
        };
        unchanged += isIn(0.1f) && before.pixels[i] == after.pixels[i]; // margins: pixels, for roundings at edges
        changed += !isIn(-0.1f) && before.pixels[i] != after.pixels[i];
    });
    CHECK(unchanged == 0);
    CHECK(changed == 0);
}

TEST_CASE("The debug ray through three panes has a sphere of kd times alpha on each", "[report]")
{
    const auto sheet = drawn("transparency.debug");
    CHECK(brokenClaim(sheet) == "");
    const glm::vec3 expected[] { 0.3f * glm::vec3(0.9f, 0.25f, 0.15f), 0.5f * glm::vec3(0.2f, 0.8f, 0.3f),
        0.7f * glm::vec3(0.2f, 0.35f, 0.95f) };
    std::size_t numSpheres = 0;
    for (const debug::Stroke& stroke : panelOf<Drawing>(sheet, 0).strokes)
        if (stroke.isFilled) {
            ++numSpheres;
            CHECK(std::ranges::any_of(expected, [&](const glm::vec3& color) {
                return glm::distance(color, stroke.color) < 1e-6f; // a rounding
            }));
        }
    CHECK(numSpheres == 3);
}
