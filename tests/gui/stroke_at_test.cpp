#include "gui/stroke_at.h"
#include <catch2/catch.hpp>

namespace {

debug::Stroke line(std::size_t shape, const glm::vec2& from, const glm::vec2& to)
{
    return { .shape = shape, .points = { from, to } };
}

debug::Stroke square(std::size_t shape, const glm::vec2& lower, float side)
{
    return { .shape = shape,
        .points = { lower, lower + glm::vec2(side, 0), lower + side, lower + glm::vec2(0, side) },
        .isFilled = true };
}

}

TEST_CASE("The line under the mouse is the nearest within the radius, between its ends alone", "[gui]")
{
    const std::vector strokes { line(3, { 10, 10 }, { 50, 10 }), line(5, { 10, 18 }, { 50, 18 }) };
    CHECK(gui::shapeAt(strokes, { 30, 13 }, 6.0f) == 3);
    CHECK(gui::shapeAt(strokes, { 30, 15 }, 6.0f) == 5);
    CHECK(gui::shapeAt(strokes, { 5, 10 }, 6.0f) == 3);
    CHECK_FALSE(gui::shapeAt(strokes, { 3, 10 }, 6.0f));
    CHECK_FALSE(gui::shapeAt(strokes, { 30, 2 }, 6.0f));
    CHECK_FALSE(gui::shapeAt({}, { 30, 2 }, 6.0f));
}

TEST_CASE("Of lines at the same place, the one drawn last is under the mouse", "[gui]")
{
    const auto once = line(1, { 10, 10 }, { 50, 10 }), again = line(2, { 10, 10 }, { 50, 10 });
    CHECK(gui::shapeAt({ once, again }, { 20, 12 }, 6.0f) == 2);
    CHECK(gui::shapeAt({ again, once }, { 20, 12 }, 6.0f) == 1);
}

TEST_CASE("An area is under the mouse wherever it covers it, unless a line is near", "[gui]")
{
    const std::vector strokes { line(1, { 0, 50 }, { 100, 50 }), square(2, { 0, 0 }, 100.0f) };
    CHECK(gui::shapeAt(strokes, { 30, 30 }, 6.0f) == 2);
    CHECK(gui::shapeAt(strokes, { 30, 48 }, 6.0f) == 1);
    CHECK(gui::shapeAt(strokes, { -4, 30 }, 6.0f) == 2); // its edge
    CHECK_FALSE(gui::shapeAt(strokes, { -30, 30 }, 6.0f));
}

TEST_CASE("A line of no length is a point", "[gui]")
{
    CHECK(gui::shapeAt({ line(4, { 7, 7 }, { 7, 7 }) }, { 9, 9 }, 6.0f) == 4);
}
