#include "gui/texture_space.h"
#include <catch2/catch.hpp>

namespace {

std::vector<std::shared_ptr<const Image>> someTextures()
{
    return { std::make_shared<Image>(4, 3), nullptr, std::make_shared<Image>(64, 48) };
}

}

TEST_CASE("A lookup is of a texture only if there is one of that number and size", "[gui]")
{
    const auto textures = someTextures();
    CHECK(gui::imageOf({ .texture = 2, .size = { 64, 48 } }, textures) == textures[2].get());
    CHECK_FALSE(gui::imageOf({ .texture = 2, .size = { 48, 64 } }, textures));
    CHECK_FALSE(gui::imageOf({ .texture = 1, .size = { 0, 0 } }, textures));
    CHECK_FALSE(gui::imageOf({ .texture = 3, .size = { 4, 3 } }, textures));
    CHECK_FALSE(gui::imageOf({ .texture = ~0u, .size = { 4, 3 } }, textures));
}

TEST_CASE("The texels around a place have it in their middle, to half a texel", "[gui]")
{
    const glm::ivec2 size { 64, 48 };
    for (float x = 0.0f; x <= 64.0f; x += 0.3f) {
        const glm::vec2 place { x, 0.7f * x };
        const auto [first, end] = gui::texelsAround(place, size, 4);
        CHECK(end - first == glm::ivec2(8));
        CHECK(glm::all(glm::lessThanEqual(glm::abs(glm::vec2(first + end) * 0.5f - place), glm::vec2(0.5f))));
    }
}

TEST_CASE("The four texels that a bilinear lookup takes are always among those around it", "[gui]")
{
    const glm::ivec2 size { 5, 7 };
    for (float x = -3.0f; x <= 8.0f; x += 0.25f) {
        const auto around = gui::texelsAround({ x, x }, size, 4);
        const glm::ivec2 lower { glm::floor(glm::vec2(x - 0.5f)) };
        for (int i = 0; i < 4; ++i) {
            const glm::ivec2 corner = lower + glm::ivec2(i % 2, i / 2);
            CHECK(around.contains(glm::clamp(corner, glm::ivec2(0), size - 1)));
        }
    }
}

TEST_CASE("Around a place that is nowhere there is still something of the texture", "[gui]")
{
    const glm::ivec2 size { 5, 7 };
    for (const float x : { NAN, INFINITY, -INFINITY, 1e30f, -1e30f }) {
        const auto [first, end] = gui::texelsAround({ x, 2.0f }, size, 4);
        CHECK(first.x < size.x);
        CHECK(end.x > 0);
    }
}

TEST_CASE("A texture of few texels has a cell for each, one of many has cells spread evenly over it", "[gui]")
{
    const glm::ivec2 few { 12, 8 };
    REQUIRE(gui::numCells(few, 64) == few);
    CHECK(gui::texelOfCell({ 11, 3 }, few, few) == glm::ivec2(11, 3));
    const glm::ivec2 many { 4096, 8 }, cells = gui::numCells(many, 64);
    REQUIRE(cells == glm::ivec2(64, 8));
    CHECK(gui::texelOfCell({ 0, 0 }, cells, many) == glm::ivec2(32, 0));
    CHECK(gui::texelOfCell({ 63, 7 }, cells, many) == glm::ivec2(4064, 7));
}
