#include "gui/magnified.h"
#include "gui/pixel_samples.h"
#include <catch2/catch.hpp>

TEST_CASE("A pixel has cells only for jittered samples whose number is a square", "[gui]")
{
    for (uint32_t row = 1; row <= 65535; row += 127) {
        const Features square { .enableJitteredSampling = true, .numPixelSamples = row * row };
        CHECK(gui::cellsInRow(square) == static_cast<int>(row));
        CHECK_FALSE(gui::cellsInRow({ .enableJitteredSampling = true, .numPixelSamples = row * row + 1 }));
        CHECK_FALSE(gui::cellsInRow({ .numPixelSamples = row * row }));
    }
}

TEST_CASE("A sample at a pixel's edge is in it, one beside it or nowhere is not", "[gui]")
{
    for (const glm::vec2& inside :
        { glm::vec2(0.5f), glm::vec2(0.0f), glm::vec2(1.0f, 0.0f), glm::vec2(-0.0001f, 1.0001f) })
        CHECK(gui::isInPixel(inside));
    for (const glm::vec2& outside : { glm::vec2(1.01f, 0.5f), glm::vec2(0.5f, -0.01f), glm::vec2(-0.5f),
             glm::vec2(0.5f, NAN), glm::vec2(INFINITY, 0.5f) })
        CHECK_FALSE(gui::isInPixel(outside));
}

TEST_CASE("What is magnified keeps its left at the left and its bottom below", "[gui]")
{
    const gui::Magnified part { { 100.0f, 50.0f }, { 3.0f, -1.0f }, { 5.0f, 2.0f }, 10.0f };
    CHECK(part.toWindow({ 3.0f, 2.0f }) == glm::vec2(100.0f, 50.0f));
    CHECK(part.toWindow({ 5.0f, -1.0f }) == glm::vec2(120.0f, 80.0f));
    CHECK(part.shows({ 3.0f, 2.0f }));
    CHECK_FALSE(part.shows({ 5.1f, 0.0f }));
    CHECK_FALSE(part.shows({ 4.0f, NAN }));
}
