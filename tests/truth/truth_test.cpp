#include "truth/light.h"
#include "truth/polygon.h"
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>

using namespace truth;

namespace {

const Receiver ground { glm::dvec3(0.0), { 0.0, 1.0, 0.0 }, glm::dvec3(1.0) };

// Of one colour, above the ground's point.
ParallelogramLight squareAbove(float side, float height)
{
    const glm::vec3 white(1.0f);
    return { { -0.5f * side, height, -0.5f * side }, { side, 0.0f, 0.0f }, { 0.0f, 0.0f, side }, white, white, white,
        white };
}

// Covers what has x < 0, half way up.
std::vector<glm::dvec3> leftHalf(double height)
{
    return { { -9.0, height, -9.0 }, { 0.0, height, -9.0 }, { 0.0, height, 9.0 }, { -9.0, height, 9.0 } };
}

}

TEST_CASE("Truth, the pixels of a polygon add up to it", "[truth]")
{
    const Polygon triangle { { 0.13, 0.21 }, { 7.9, 2.3 }, { 3.3, 6.77 } };
    double sum = 0.0;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            sum += areaOf(clipToRectangle(triangle, glm::dvec2(x, y), glm::dvec2(x + 1, y + 1)));
    CHECK(sum == Approx(areaOf(triangle)).epsilon(1e-13)); // 64 sums of a few roundings of 2^-53
}

TEST_CASE("Truth, a square light is what its integral in closed form says", "[truth]")
{
    // Of h / sqrt(x^2 + y^2 + h^2) over [0, a]^2.
    const double a = 0.5, h = 2.0;
    const double quarter = h
        * (2.0 * a * std::asinh(a / std::hypot(a, h)) - h * std::atan(a * a / (h * std::sqrt(2.0 * a * a + h * h))));
    const glm::dvec3 light = contribution(squareAbove(1.0f, 2.0f), ground, {});
    CHECK(light.x == Approx(quarter / (a * a)).margin(1e-10));
}

TEST_CASE("Truth, a segment light is what its integral in closed form says", "[truth]")
{
    const glm::vec3 white(1.0f);
    const SegmentLight light { { -1.0f, 2.0f, 0.0f }, { 1.0f, 2.0f, 0.0f }, white, white };
    CHECK(contribution(light, ground, {}).x == Approx(2.0 * std::asinh(0.5)).margin(1e-10));
    CHECK(contribution(light, ground, leftHalf(1.0)).x == Approx(std::asinh(0.5)).margin(1e-10));
}

TEST_CASE("Truth, a blocker over half of a light leaves half of it", "[truth]")
{
    const ParallelogramLight light = squareAbove(1.0f, 2.0f);
    const double all = contribution(light, ground, {}).x;
    CHECK(contribution(light, ground, leftHalf(1.0)).x == Approx(0.5 * all).margin(1e-10));
    CHECK(contribution(light, ground, leftHalf(0.001)).x == Approx(0.5 * all).margin(1e-10));
}

TEST_CASE("Truth, light that reaches below the surface counts above it only", "[truth]")
{
    const glm::vec3 white(1.0f);
    const ParallelogramLight wall { { 1.0f, -1.0f, -0.5f }, { 0.0f, 2.0f, 0.0f }, { 0.0f, 0.0f, 1.0f }, white, white,
        white, white };
    const ParallelogramLight upperHalf { { 1.0f, 0.0f, -0.5f }, { 0.0f, 1.0f, 0.0f }, { 0.0f, 0.0f, 1.0f }, white,
        white, white, white };
    CHECK(contribution(wall, ground, {}).x == Approx(0.5 * contribution(upperHalf, ground, {}).x).margin(1e-10));
}

TEST_CASE("Truth, a blocker in any place leaves what a fine grid of points sees", "[truth]")
{
    const ParallelogramLight light { { -1.0f, 2.0f, -0.7f }, { 2.0f, 0.3f, 0.1f }, { 0.2f, 0.4f, 1.5f }, { 1, 0, 0 },
        { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } };
    const std::vector<glm::dvec3> blocker { { -0.3, 1.0, -0.2 }, { 0.3, 1.1, -0.1 }, { 0.1, 1.0, 0.4 } };
    const auto isBlocked = [&](const glm::dvec3& to) { // the side of each edge, as seen from the ground's point
        const double a = glm::dot(to, glm::cross(blocker[0], blocker[1]));
        const double b = glm::dot(to, glm::cross(blocker[1], blocker[2]));
        const double c = glm::dot(to, glm::cross(blocker[2], blocker[0]));
        return (a > 0.0 && b > 0.0 && c > 0.0) || (a < 0.0 && b < 0.0 && c < 0.0);
    };
    constexpr int side = 1500;
    glm::dvec3 sum(0.0);
    for (int i = 0; i < side * side; ++i) {
        const glm::dvec2 uv = (glm::dvec2(i % side, i / side) + 0.5) / static_cast<double>(side);
        const glm::dvec3 position
            = glm::dvec3(light.v0) + uv.x * glm::dvec3(light.edge01) + uv.y * glm::dvec3(light.edge02);
        if (isBlocked(position))
            continue;
        const glm::dvec3 color = glm::mix(glm::mix(glm::dvec3(light.color0), glm::dvec3(light.color1), uv.x),
            glm::mix(glm::dvec3(light.color2), glm::dvec3(light.color3), uv.x), uv.y);
        sum += color * glm::normalize(position).y;
    }
    sum /= side * side;
    const glm::dvec3 exact = contribution(light, ground, blocker);
    for (int i = 0; i < 3; ++i) // cells along the outline, about 4 * side of side^2, are right on average
        CHECK(exact[i] == Approx(sum[i]).margin(1e-4));
}
