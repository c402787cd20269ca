#include "grading/oracle/random_scene.h"
#include "intersect.h"
#include <catch2/catch.hpp>
#include <optional>

using grading::Random;

namespace {

using Corners = std::array<glm::vec3, 3>;

Corners randomCorners(Random& random)
{
    const auto vertices = grading::randomTriangle(random, glm::vec3(0.0f));
    return { vertices[0].position, vertices[1].position, vertices[2].position };
}

struct Hit {
    float t;
    glm::vec3 normal;
};

std::optional<Hit> hitOf(const Corners& corners, Ray ray)
{
    const float end = ray.t;
    HitInfo hitInfo;
    hitInfo.normal = glm::vec3(7.0f);
    const bool meets = intersectRayWithTriangle(corners[0], corners[1], corners[2], ray, hitInfo);
    if (!meets)
        CHECK((ray.t == end && hitInfo.normal == glm::vec3(7.0f)));
    return meets ? std::optional(Hit { ray.t, hitInfo.normal }) : std::nullopt;
}

// A ray from up to 3 away through the triangle's point with these weights, more than 3 degrees from its plane.
Ray rayThrough(const Corners& corners, const glm::vec3& weights, Random& random)
{
    const glm::vec3 point = weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
    const glm::vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    for (;;) {
        const glm::vec3 direction = random.direction();
        if (std::abs(glm::dot(direction, normal)) > 0.05f)
            return { point - random.uniform(0.1f, 3.0f) * direction, direction };
    }
}

// The distance to the plane, in double precision.
double planeDistance(const Corners& corners, const Ray& ray)
{
    const glm::dvec3 a { corners[0] }, b { corners[1] }, c { corners[2] };
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    return glm::dot(normal, a - glm::dvec3(ray.origin)) / glm::dot(normal, glm::dvec3(ray.direction));
}

const Corners simple { { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 } } };
const glm::vec3 down { 0, 0, -1 };

}

TEST_CASE("Triangle, is met by a ray through a point of it and missed outside, at any size", "[triangle]")
{
    Random random(1, "triangle");
    for (const float scale : { 1e-3f, 1.0f, 1e3f }) {
        CAPTURE(scale);
        for (int i = 0; i < 2000; ++i) {
            Corners corners = randomCorners(random);
            glm::vec3 weights = random.vec3(-1.0f, 1.0f);
            weights.z = 1.0f - weights.x - weights.y;
            const float margin = std::min({ weights.x, weights.y, weights.z });
            Ray ray = rayThrough(corners, weights, random);
            for (glm::vec3& corner : corners)
                corner *= scale;
            ray.origin *= scale;
            if (std::abs(margin) < 0.01f) // rounding may decide
                continue;
            const auto hit = hitOf(corners, ray);
            REQUIRE(hit.has_value() == (margin > 0.0f));
            if (!hit)
                continue;
            // Grazing by 3 degrees magnifies roundings 20 times, slivers 10 times.
            CHECK(static_cast<double>(hit->t)
                == Approx(planeDistance(corners, ray)).margin(1e-4 * static_cast<double>(scale)));
            CHECK(std::abs(glm::length(hit->normal) - 1.0f) < 1e-6f);
        }
    }
}

TEST_CASE("Triangle, has two sides, and its normal faces the ray", "[triangle]")
{
    Random random(1, "sides");
    for (int i = 0; i < 1000; ++i) {
        const Corners corners = randomCorners(random), reversed { corners[0], corners[2], corners[1] };
        const Ray ray = rayThrough(corners, { 0.3f, 0.3f, 0.4f }, random);
        const auto front = hitOf(corners, ray), back = hitOf(reversed, ray);
        REQUIRE(front);
        REQUIRE(back);
        CHECK(front->t == back->t);
        CHECK(front->normal == back->normal);
        CHECK(glm::dot(front->normal, ray.direction) < 0.0f);
    }
}

TEST_CASE("Triangle, its edges and corners belong to it", "[triangle]")
{
    for (const glm::vec2& at :
        { glm::vec2(0, 0), { 4, 0 }, { 0, 4 }, { 2, 0 }, { 0, 1 }, { 2, 2 }, { 3, 1 }, { 1, 1 } }) {
        CAPTURE(at);
        CHECK(hitOf(simple, { glm::vec3(at, 2), down }));
        CHECK(hitOf(simple, { glm::vec3(at, -2), -down }));
    }
    for (const glm::vec2& at : { glm::vec2(-1e-6f, 1), { 1, -1e-6f }, { 2, 2.00001f }, { 4.00001f, 0 } })
        CHECK_FALSE(hitOf(simple, { glm::vec3(at, 2), down }));
}

TEST_CASE("Triangle, the distance lies between 0 and the end of the ray, both included", "[triangle]")
{
    CHECK(hitOf(simple, { { 1, 1, 2 }, down, 2.0f }).value().t == 2.0f);
    CHECK(hitOf(simple, { { 1, 1, 2 }, 4.0f * down, 0.5f }).value().t == 0.5f); // in units of the direction
    CHECK_FALSE(hitOf(simple, { { 1, 1, 2 }, down, 1.999f }));
    CHECK(hitOf(simple, { { 1, 1, 0 }, down }).value().t == 0.0f);
    CHECK(hitOf(simple, { { 1, 1, 0 }, down, 0.0f }).value().t == 0.0f);
    CHECK_FALSE(hitOf(simple, { { 1, 1, -1e-6f }, down }));
    CHECK(hitOf(simple, { { 1, 1, 2 }, down, std::numeric_limits<float>::infinity() }).value().t == 2.0f);
}

TEST_CASE("Triangle, is missed by rays in its plane, and without area by all", "[triangle]")
{
    CHECK_FALSE(hitOf(simple, { { -1, 1, 0 }, { 1, 0, 0 } }));
    CHECK_FALSE(hitOf({ glm::vec3(0), glm::vec3(0), glm::vec3(0) }, { { 0, 0, 2 }, down }));
    CHECK_FALSE(hitOf({ glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(2, 0, 0) }, { { 1, 0, 2 }, down }));
    CHECK_FALSE(hitOf({ glm::vec3(0), glm::vec3(0), glm::vec3(2, 0, 0) }, { { 1, 0, 2 }, down }));
}

TEST_CASE("Triangle, shared edges let no ray through", "[triangle]")
{
    Random random(1, "shared edge");
    for (int i = 0; i < 50'000; ++i) {
        const Corners first = randomCorners(random);
        const glm::vec3 inward = 0.5f * (first[0] + first[1]) - first[2];
        const Corners second { first[1], first[0], 0.5f * (first[0] + first[1]) + inward + 0.2f * random.direction() };
        const float s = random.uniform(0.01f, 0.99f);
        const Ray ray = rayThrough(first, { s, 1.0f - s, 0.0f }, random); // on the edge, but for rounding
        const float crossed = glm::dot(ray.direction, glm::cross(second[1] - second[0], second[2] - second[0]));
        const float mine = glm::dot(ray.direction, glm::cross(first[1] - first[0], first[2] - first[0]));
        if (crossed * mine < 0.0f) // a fold seen from the side: the ray may pass both
            continue;
        CHECK((hitOf(first, ray) || hitOf(second, ray)));
    }
}

TEST_CASE("Triangle, its plane has its corners, and the points in it are found", "[triangle]")
{
    Random random(1, "plane of");
    for (int i = 0; i < 1000; ++i) {
        const Corners corners = randomCorners(random);
        const Plane plane = trianglePlane(corners[0], corners[1], corners[2]);
        CHECK(std::abs(glm::length(plane.normal) - 1.0f) < 1e-6f);
        for (const glm::vec3& corner : corners)
            CHECK(std::abs(glm::dot(corner, plane.normal) - plane.D) < 1e-5f); // slivers magnify roundings ten times
        glm::vec3 weights = random.vec3(-1.0f, 1.0f);
        weights.z = 1.0f - weights.x - weights.y;
        const float margin = std::min({ weights.x, weights.y, weights.z });
        const glm::vec3 point = weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
        if (std::abs(margin) > 0.01f)
            CHECK(pointInTriangle(corners[0], corners[1], corners[2], plane.normal, point) == (margin > 0.0f));
    }
}
