#include "debug/false_color.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <numeric>

using debug::Quantity;
using debug::Range;

namespace {

constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();

// Ottosson 2020, "A perceptual color space for image processing": distances are about as large as they look.
glm::dvec3 oklab(const glm::vec3& color)
{
    const auto toLinear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    const double r = toLinear(color.r), g = toLinear(color.g), b = toLinear(color.b);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return { 0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
        1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
        0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s };
}

double lightness(const glm::vec3& color)
{
    return oklab(color).x;
}

glm::vec3 number(float x)
{
    return { x, 0.0f, 0.0f };
}

}

TEST_CASE("The heat of a larger number is lighter, and no heat is black", "[false_color]")
{
    constexpr int numSteps = 1000;
    double before = 0.2; // clearly more than black
    for (int i = 0; i <= numSteps; ++i) {
        const glm::vec3 color = debug::heat(static_cast<float>(i) / numSteps);
        CHECK(glm::all(glm::greaterThanEqual(color, glm::vec3(0.0f))));
        CHECK(glm::all(glm::lessThanEqual(color, glm::vec3(1.0f))));
        CHECK(lightness(color) > before);
        before = lightness(color);
    }
}

TEST_CASE("Equal steps of a number look equal", "[false_color]")
{
    constexpr int numSteps = 32;
    std::vector<double> steps;
    for (int i = 0; i < numSteps; ++i)
        steps.push_back(glm::distance(oklab(debug::heat(static_cast<float>(i) / numSteps)),
            oklab(debug::heat(static_cast<float>(i + 1) / numSteps))));
    const double mean = std::accumulate(steps.begin(), steps.end(), 0.0) / numSteps;
    CHECK(std::ranges::min(steps) > 0.8 * mean); // as even as nine colours are: a rainbow has steps of a third
    CHECK(std::ranges::max(steps) < 1.25 * mean);
}

TEST_CASE("Nothing is black and NaN is magenta, whatever is shown but colours", "[false_color]")
{
    for (const Quantity quantity : debug::allQuantities()) {
        INFO(debug::nameOf(quantity));
        if (quantity == Quantity::Color)
            continue;
        CHECK(debug::falseColor(quantity, debug::nothing, { 1.0f, 2.0f }) == glm::vec3(0.0f));
        CHECK(debug::falseColor(quantity, { notANumber, 0.5f, 0.5f }, { 1.0f, 2.0f }) == glm::vec3(1, 0, 1));
        CHECK(debug::falseColor(quantity, { 1.5f, 0.0f, 0.0f }, { 1.0f, 2.0f }) != glm::vec3(0.0f));
    }
    const glm::vec3 bright { 3.0f, -1.0f, 0.5f };
    CHECK(debug::falseColor(Quantity::Color, bright, {}) == bright);
}

TEST_CASE("Vectors are colours of their own", "[false_color]")
{
    const auto colorOf = [](Quantity quantity, const glm::vec3& value) {
        return debug::falseColor(quantity, value, debug::rangeOf(quantity, {}));
    };
    CHECK(colorOf(Quantity::Normal, { 0, 1, 0 }) == glm::vec3(0.5f, 1.0f, 0.5f));
    CHECK(colorOf(Quantity::Normal, { -1, 0, 0 }) == glm::vec3(0.0f, 0.5f, 0.5f));
    CHECK(colorOf(Quantity::TexCoord, { 0.25f, 0.75f, 0.0f }) == glm::vec3(0.25f, 0.75f, 0.0f));
    CHECK(colorOf(Quantity::Barycentric, { 0.5f, 0.25f, 0.25f }) == glm::vec3(0.5f, 0.25f, 0.25f));
    CHECK(colorOf(Quantity::TexCoord, { -3.0f, 7.0f, 0.0f }) == glm::vec3(0.0f, 1.0f, 0.0f));
}

TEST_CASE("Counts range from zero and distances from the least, over what is there", "[false_color]")
{
    const std::vector<glm::vec3> values { number(5.0f), debug::nothing, number(3.0f), number(notANumber),
        number(9.0f) };
    for (const Quantity quantity :
        { Quantity::NodesVisited, Quantity::TrianglesTested, Quantity::Samples, Quantity::Rays, Quantity::Distance }) {
        INFO(debug::nameOf(quantity));
        const Range range = debug::rangeOf(quantity, values);
        CHECK(range.lowest == (quantity == Quantity::Distance ? 3.0f : 0.0f));
        CHECK(range.highest == 9.0f);
        CHECK(debug::falseColor(quantity, number(range.lowest), range) == debug::heat(0.0f));
        CHECK(debug::falseColor(quantity, number(range.highest), range) == debug::heat(1.0f));
    }
}

TEST_CASE("A picture of one number, or of none, has colours", "[false_color]")
{
    for (const auto& values : { std::vector<glm::vec3>(3, number(2.0f)), std::vector<glm::vec3>(3, debug::nothing) }) {
        const Range range = debug::rangeOf(Quantity::Distance, values);
        CHECK(range.lowest == range.highest);
        CHECK(std::isfinite(range.lowest));
        CHECK(debug::falseColor(Quantity::Distance, number(range.lowest), range) == debug::heat(0.0f));
    }
}

TEST_CASE("A quantity has a name that it is found by, and the next one leads round to the first", "[false_color]")
{
    Quantity stepped = Quantity::Color;
    for (const Quantity quantity : debug::allQuantities()) {
        CHECK(stepped == quantity);
        CHECK(debug::quantityOf(debug::nameOf(quantity)) == quantity);
        stepped = debug::nextOf(stepped);
    }
    CHECK(stepped == Quantity::Color);
    CHECK_THROWS_WITH(debug::quantityOf("norm"),
        Catch::Contains("found the quantity 'norm', expected one of color, normal, tex_coord"));
}

TEST_CASE("A value is told with the name of what it is", "[false_color]")
{
    CHECK(debug::describe(Quantity::Normal, { 0, 1, 0 }) == "normal (0, 1, 0)");
    CHECK(debug::describe(Quantity::TexCoord, { 0.25f, 0.5f, 0 }) == "tex_coord (0.25, 0.5)");
    CHECK(debug::describe(Quantity::Distance, number(3.25f)) == "t 3.25");
    CHECK(debug::describe(Quantity::NodesVisited, number(123456.0f)) == "nodes_visited 123456");
    CHECK(debug::describe(Quantity::Distance, debug::nothing) == "nothing there");
}
