#include "grading/random.h"
#include "intersect.h"
#include <catch2/catch.hpp>
#include <optional>

using grading::Random;

namespace {

std::optional<float> distanceTo(const Sphere& sphere, Ray ray)
{
    HitInfo hit;
    return intersectRayWithShape(sphere, ray, hit) ? std::optional(ray.t) : std::nullopt;
}

std::optional<float> distanceTo(const Plane& plane, Ray ray)
{
    const float end = ray.t;
    const bool meets = intersectRayWithPlane(plane, ray);
    CHECK((meets || ray.t == end));
    return meets ? std::optional(ray.t) : std::nullopt;
}

const Sphere unit { .center = { 0, 0, 0 }, .radius = 1.0f };

}

TEST_CASE("Sphere, a hit lies on it, is the first, and its normal faces the ray", "[sphere]")
{
    Random random(1, "sphere");
    int numHits = 0;
    for (int i = 0; i < 40'000; ++i) {
        const Sphere sphere { random.vec3(-1.0f, 1.0f), random.uniform(0.05f, 1.0f) };
        Ray ray { random.vec3(-2.0f, 2.0f), random.uniform(0.3f, 3.0f) * random.direction() };
        const glm::dvec3 o = glm::dvec3(ray.origin) - glm::dvec3(sphere.center), d { ray.direction };
        const double r { sphere.radius }, a = glm::dot(d, d), b = glm::dot(o, d), c = glm::dot(o, o) - r * r;
        const double discriminant = b * b - a * c;
        if (std::abs(discriminant) < 1e-3 * a || std::abs(c) < 1e-3) // rounding may decide
            continue;
        const double near = (-b - std::sqrt(std::max(discriminant, 0.0))) / a;
        const double far = (-b + std::sqrt(std::max(discriminant, 0.0))) / a;
        HitInfo hit;
        REQUIRE(intersectRayWithShape(sphere, ray, hit) == (discriminant > 0.0 && far > 0.0));
        if (discriminant < 0.0 || far < 0.0)
            continue;
        ++numHits;
        CHECK(static_cast<double>(ray.t)
            == Approx(near > 0.0 ? near : far).margin(1e-4)); // near a tangent the root magnifies
        const glm::dvec3 outwards = (o + static_cast<double>(ray.t) * d) / r;
        CHECK(
            glm::distance(glm::dvec3(hit.normal), near > 0.0 ? outwards : -outwards) < 1e-3); // of the smallest spheres
        CHECK(glm::dot(hit.normal, ray.direction) <= 0.0f);
    }
    CHECK(numHits > 1000);
}

TEST_CASE("Sphere, fills all of a hit", "[sphere]")
{
    Sphere sphere = unit;
    sphere.material.kd = glm::vec3(0.25f);
    Ray ray { { 0, 0, 3 }, { 0, 0, -2 } };
    HitInfo hit;
    REQUIRE(intersectRayWithShape(sphere, ray, hit));
    CHECK(ray.t == 1.0f); // in units of the direction
    CHECK(hit.normal == glm::vec3(0, 0, 1));
    CHECK(hit.barycentricCoord == glm::vec3(0.0f));
    CHECK(hit.texCoord == glm::vec2(0.0f));
    CHECK(hit.material.kd == glm::vec3(0.25f));
}

TEST_CASE("Sphere, from inside and from its surface", "[sphere]")
{
    CHECK(distanceTo(unit, { { 0, 0, 0.5f }, { 0, 0, 1 } }) == 0.5f);
    CHECK(distanceTo(unit, { { 0, 0, 0.5f }, { 0, 0, -1 } }) == 1.5f);
    CHECK(distanceTo(unit, { { 0, 0, 0 }, { 0, 1, 0 } }) == 1.0f);
    CHECK(distanceTo(unit, { { 0, 0, 1 }, { 0, 0, 1 } }) == 0.0f);
    CHECK(distanceTo(unit, { { 0, 0, 1 }, { 0, 0, -1 } }) == 0.0f);
}

TEST_CASE("Sphere, a tangent meets it, a ray just beside, behind or too short does not", "[sphere]")
{
    CHECK(distanceTo(unit, { { 1, 0, 3 }, { 0, 0, -1 } }) == 3.0f);
    CHECK_FALSE(distanceTo(unit, { { 1.0001f, 0, 3 }, { 0, 0, -1 } }));
    CHECK_FALSE(distanceTo(unit, { { 0, 0, 3 }, { 0, 0, 1 } }));
    CHECK_FALSE(distanceTo(unit, { { 0, 0, 3 }, { 0, 0, -1 }, 1.999f }));
    CHECK(distanceTo(unit, { { 0, 0, 3 }, { 0, 0, -1 }, 2.0f }) == 2.0f);
    CHECK_FALSE(distanceTo(unit, { { 0, 0, 0 }, { 0, 0, 1 }, 0.5f })); // ends inside
}

TEST_CASE("Sphere, a small one far away keeps its digits", "[sphere]")
{
    for (const float away : { 1e2f, 1e3f, 1e4f }) {
        const auto t = distanceTo({ .center = { 0, 0, -away }, .radius = 0.1f }, Ray { { 0.05f, 0, 0 }, { 0, 0, -1 } });
        REQUIRE(t);
        CHECK(*t == Approx(away - std::sqrt(0.01f - 0.0025f)).epsilon(1e-6));
    }
}

TEST_CASE("Plane, a hit lies in it", "[plane]")
{
    Random random(1, "plane");
    int numHits = 0;
    for (int i = 0; i < 5000; ++i) {
        const Plane plane { random.uniform(-1.0f, 1.0f), random.direction() };
        const Ray ray { random.vec3(-2.0f, 2.0f), random.uniform(0.3f, 3.0f) * random.direction() };
        const glm::dvec3 n { plane.normal }, o { ray.origin }, d { ray.direction };
        const double expected = (static_cast<double>(plane.D) - glm::dot(n, o)) / glm::dot(n, d);
        if (std::abs(glm::dot(n, d)) < 0.01 || std::abs(expected) < 1e-3)
            continue;
        const auto t = distanceTo(plane, ray);
        REQUIRE(t.has_value() == (expected > 0.0));
        if (!t)
            continue;
        ++numHits;
        CHECK(static_cast<double>(*t) == Approx(expected).margin(1e-4)); // a grazing cosine of 0.01 magnifies 100 times
    }
    CHECK(numHits > 1000);
}

TEST_CASE("Plane, is not met behind, beyond the end, or by rays along it", "[plane]")
{
    const Plane ground { .D = 1.0f };
    CHECK(distanceTo(ground, { { 0, 3, 0 }, { 0, -1, 0 } }) == 2.0f);
    CHECK(distanceTo(ground, { { 0, -3, 0 }, { 0, 2, 0 } }) == 2.0f); // from below, in units of the direction
    CHECK(distanceTo(ground, { { 0, 3, 0 }, { 0, -1, 0 }, 2.0f }) == 2.0f);
    CHECK_FALSE(distanceTo(ground, { { 0, 3, 0 }, { 0, -1, 0 }, 1.9f }));
    CHECK_FALSE(distanceTo(ground, { { 0, 3, 0 }, { 0, 1, 0 } }));
    CHECK_FALSE(distanceTo(ground, { { 0, 3, 0 }, { 1, 0, 0 } }));
    CHECK_FALSE(distanceTo(ground, { { 0, 1, 0 }, { 1, 0, 0 } })); // in the plane
}
