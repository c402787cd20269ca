#include "grading/random.h"
#include "intersect.h"
#include <catch2/catch.hpp>
#include <optional>

using grading::Random;

namespace {

const AxisAlignedBox unitBox { glm::vec3(0.0f), glm::vec3(1.0f) };

std::optional<float> entry(const AxisAlignedBox& box, Ray ray)
{
    const float end = ray.t;
    const bool meets = intersectRayWithShape(box, ray);
    CHECK((meets || ray.t == end));
    return meets ? std::optional(ray.t) : std::nullopt;
}

struct Overlap {
    double entry, exit;
};

// By slabs, in double precision; no direction is 0.
Overlap overlapOf(const AxisAlignedBox& box, const Ray& ray)
{
    Overlap overlap { 0.0, ray.t };
    for (int axis = 0; axis < 3; ++axis) {
        const double origin { ray.origin[axis] }, direction { ray.direction[axis] };
        const auto [first, last] = std::minmax({ (static_cast<double>(box.lower[axis]) - origin) / direction,
            (static_cast<double>(box.upper[axis]) - origin) / direction });
        overlap = { std::max(overlap.entry, first), std::min(overlap.exit, last) };
    }
    return overlap;
}

}

TEST_CASE("Box, is met where slabs in double precision say", "[box]")
{
    Random random(1, "box");
    std::array<int, 2> count {};
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec3 a = random.vec3(-1.0f, 1.0f), b = random.vec3(-1.0f, 1.0f);
        const AxisAlignedBox box { glm::min(a, b), glm::max(a, b) };
        Ray ray { random.vec3(-2.0f, 2.0f), random.uniform(0.2f, 2.0f) * random.direction() };
        if (i % 2 == 0)
            ray.t = random.uniform(0.0f, 3.0f);
        const Overlap expected = overlapOf(box, ray);
        if (std::abs(expected.exit - expected.entry) < 1e-4) // rounding may decide, if only towards a hit
            continue;
        const auto t = entry(box, ray);
        ++count[t.has_value()];
        REQUIRE(t.has_value() == (expected.entry < expected.exit));
        if (t)
            CHECK(static_cast<double>(*t) == Approx(expected.entry).epsilon(1e-5).margin(1e-5));
    }
    CHECK(count[0] > 1000);
    CHECK(count[1] > 300);
}

TEST_CASE("Box, a point of it is never missed", "[box]")
{
    Random random(1, "box point");
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec3 a = random.vec3(-1.0f, 1.0f), b = random.vec3(-1.0f, 1.0f);
        const AxisAlignedBox box { glm::min(a, b), glm::max(a, b) };
        glm::vec3 corner;
        for (int axis = 0; axis < 3; ++axis)
            corner[axis] = random.integer(0, 1) ? box.lower[axis] : box.upper[axis];
        const glm::vec3 away = random.direction();
        // Aimed at the corner from inside the box's other octants: passing exactly through is up to rounding, the ray
        // that starts there is not.
        CHECK(entry(box, { corner, away }) == 0.0f);
        CHECK(entry(box, { glm::mix(box.lower, box.upper, random.vec3()), away }) == 0.0f);
    }
}

TEST_CASE("Box, a ray from inside meets it at 0, one that ends before or points away does not", "[box]")
{
    CHECK(entry(unitBox, { glm::vec3(0.5f), { 1, 2, 3 } }) == 0.0f);
    CHECK(entry(unitBox, { { -1, 0.5f, 0.5f }, { 1, 0, 0 } }) == 1.0f);
    CHECK(entry(unitBox, { { -1, 0.5f, 0.5f }, { 1, 0, 0 }, 1.0f }) == 1.0f);
    CHECK(entry(unitBox, { { -1, 0.5f, 0.5f }, { 1, 0, 0 }, 0.9f }) == std::nullopt);
    CHECK(entry(unitBox, { { -1, 0.5f, 0.5f }, { -1, 0, 0 } }) == std::nullopt);
    CHECK(entry(unitBox, { { 0.5f, 0.5f, 0.5f }, { 1, 0, 0 }, 0.0f }) == 0.0f);
}

TEST_CASE("Box, rays along an axis on its faces and edges meet it, beside them they do not", "[box]")
{
    const float infinity = std::numeric_limits<float>::infinity();
    const float beside = std::nextafter(1.0f, 2.0f);
    for (const float end : { FLT_MAX, infinity, 5.0f }) {
        for (int axis = 0; axis < 3; ++axis) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            for (const float zero : { 0.0f, -0.0f }) {
                for (const float side : { 1.0f, -1.0f }) {
                    CAPTURE(axis, zero, side, end);
                    Ray ray { glm::vec3(0.5f), glm::vec3(zero), end };
                    ray.direction[axis] = side;
                    ray.origin[axis] = 0.5f - 2.0f * side;
                    for (const float atU : { 0.0f, 0.5f, 1.0f }) {
                        for (const float atV : { 0.0f, 0.5f, 1.0f }) {
                            ray.origin[u] = atU;
                            ray.origin[v] = atV;
                            CHECK(entry(unitBox, ray) == 1.5f);
                        }
                        ray.origin[v] = beside;
                        CHECK(entry(unitBox, ray) == std::nullopt);
                        ray.origin[v] = -1e-30f;
                        CHECK(entry(unitBox, ray) == std::nullopt);
                    }
                }
            }
        }
    }
}

TEST_CASE("Box, a flat one and a point are met", "[box]")
{
    const AxisAlignedBox flat { { -1, -1, 2 }, { 1, 1, 2 } }, point { glm::vec3(0, 0, 2), glm::vec3(0, 0, 2) };
    for (const glm::vec3& direction : { glm::vec3(0, 0, 1), glm::vec3(-0.0f, 0, 0.5f) }) {
        CHECK(entry(flat, { glm::vec3(0.0f), direction }) == 2.0f / direction.z);
        CHECK(entry(point, { glm::vec3(0.0f), direction }) == 2.0f / direction.z);
    }
    CHECK(entry(flat, { { -3, 0, 2 }, { 1, 0, 0 } }) == 2.0f); // in its plane
    CHECK(entry(flat, { { -3, 0, 2.001f }, { 1, 0, 0 } }) == std::nullopt);
}
