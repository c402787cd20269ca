#include "screen.h"
#include <catch2/catch.hpp>
#include <framework/image.h>

TEST_CASE("A screen's pixels are where indexAt says, row 0 first", "[screen]")
{
    Screen screen({ 3, 2 });
    CHECK(screen.resolution() == glm::ivec2(3, 2));
    REQUIRE(screen.pixels().size() == 6);
    for (const glm::vec3& pixel : screen.pixels())
        CHECK(pixel == glm::vec3(0.0f));
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x)
            screen.setPixel(x, y, glm::vec3(x, y, 7)); // beyond 1: nothing is clamped
    for (int i = 0; i < 6; ++i)
        CHECK(screen.pixels()[static_cast<std::size_t>(i)] == glm::vec3(i % 3, i / 3, 7));
    CHECK(screen.indexAt(2, 1) == 5);
}

TEST_CASE("Clearing a screen sets every pixel and starts the count of rows again", "[screen]")
{
    Screen screen({ 3, 2 });
    screen.setPixel(0, 0, glm::vec3(1.0f));
    screen.setPixel(1, 0, glm::vec3(1.0f));
    screen.setPixel(0, 1, glm::vec3(1.0f));
    CHECK(screen.rowsStarted() == 2);
    screen.clear(glm::vec3(0.5f));
    CHECK(screen.rowsStarted() == 0);
    for (const glm::vec3& pixel : screen.pixels())
        CHECK(pixel == glm::vec3(0.5f));
}

TEST_CASE("An image reads back all 256 steps of a channel, by either way of reading", "[image]")
{
    Image image(16, 16);
    for (int i = 0; i < 256; ++i)
        image.set_pixel(i, glm::vec3(i, 255 - i, 7) / 255.0f);
    for (int i = 0; i < 256; ++i) {
        CHECK(image.get_data()[3 * i] == i);
        CHECK(image.get_pixel(i) == glm::vec3(i, 255 - i, 7) / 255.0f);
        CHECK(image.pixels[static_cast<std::size_t>(i)] == image.get_pixel(i));
    }
    CHECK(image.pixels.size() == 256);
}

TEST_CASE("An image stores the nearest step, clamped", "[image]")
{
    Image image(1, 1);
    image.set_pixel(0, glm::vec3(-1.0f, 2.0f, 100.4f / 255.0f));
    CHECK(image.get_pixel(0) == glm::vec3(0, 255, 100) / 255.0f);
    image.set_pixel(0, glm::vec3(100.6f / 255.0f));
    CHECK(image.get_pixel(0) == glm::vec3(101) / 255.0f);
}

TEST_CASE("An image of one, two or four channels is read and written as three", "[image]")
{
    for (const int channels : { 1, 2, 4 }) {
        Image image(2, 1, channels);
        const glm::vec4 stored = glm::vec4(1, 2, 3, 4) / 255.0f;
        image.set_pixel<4>(1, stored);
        for (int c = 0; c < 3; ++c) {
            const float expected = stored[std::min(c, channels - 1)]; // the last one is repeated
            CHECK(image.get_pixel(1)[c] == expected);
            CHECK(image.pixels[1][c] == expected);
        }
        CHECK(image.get_pixel(0) == glm::vec3(0.0f)); // the neighbour is untouched
        CHECK(image.pixels.size() == 2);
    }
}
