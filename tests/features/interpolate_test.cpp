#include "grading/oracle/random_scene.h"
#include "grading/oracle/triangle.h"
#include "interpolate.h"
#include "world.h"
#include <catch2/catch.hpp>
#include <glm/gtc/quaternion.hpp>

using namespace tests;
using grading::Random;
using Corners = std::array<glm::vec3, 3>;

namespace {

Corners randomCorners(Random& random)
{
    const auto vertices = grading::randomTriangle(random, glm::vec3(0.0f));
    return { vertices[0].position, vertices[1].position, vertices[2].position };
}

// Slivers, segments and points too.
Corners anyCorners(Random& random, int kind)
{
    Corners corners = randomCorners(random);
    if (kind % 4 == 1)
        corners[2] = glm::mix(corners[0], corners[1], random.uniform(-1.0f, 2.0f));
    if (kind % 4 == 2)
        corners[1] = corners[0];
    if (kind % 4 == 3)
        corners = { corners[0], corners[0], corners[0] };
    return corners;
}

glm::vec3 randomWeights(Random& random)
{
    const glm::vec2 xy = random.vec2();
    const glm::vec2 inTriangle = xy.x + xy.y > 1.0f ? 1.0f - xy : xy;
    return { 1.0f - inTriangle.x - inTriangle.y, inTriangle };
}

glm::dvec3 pointAt(const Corners& corners, const glm::vec3& bc)
{
    return grading::pointAt({ glm::dvec3(corners[0]), glm::dvec3(corners[1]), glm::dvec3(corners[2]) }, glm::dvec3(bc));
}

glm::vec3 barycentric(const Corners& corners, const glm::vec3& p)
{
    return computeBarycentricCoord(corners[0], corners[1], corners[2], p);
}

// Edges are longer than 0.1 and heights than a tenth of them: what single precision loses on a number of about 1 is
// magnified by this.
constexpr double slenderRounding = 1e-4;

}

TEST_CASE("Barycentrics, sum to one and lie between 0 and 1, whatever the triangle and the point", "[interpolate]")
{
    Random random(1, "sum");
    for (int i = 0; i < 4000; ++i) {
        const Corners corners = anyCorners(random, i);
        for (const glm::vec3& p :
            { random.vec3(-2.0f, 2.0f), corners[0], corners[2], 0.5f * (corners[0] + corners[1]) }) {
            const glm::vec3 bc = barycentric(corners, p);
            CHECK(std::abs(bc.x + bc.y + bc.z - 1.0f) < 1e-6f); // three roundings
            CHECK(std::min({ bc.x, bc.y, bc.z }) >= 0.0f);
            CHECK(std::max({ bc.x, bc.y, bc.z }) <= 1.0f);
        }
    }
}

TEST_CASE("Barycentrics of a corner are a unit vector, exactly", "[interpolate]")
{
    Random random(1, "corner");
    for (int i = 0; i < 500; ++i) {
        const Corners corners = randomCorners(random);
        CHECK(barycentric(corners, corners[0]) == glm::vec3(1, 0, 0));
        CHECK(barycentric(corners, corners[1]) == glm::vec3(0, 1, 0));
        CHECK(barycentric(corners, corners[2]) == glm::vec3(0, 0, 1));
    }
}

TEST_CASE("Barycentrics give back the weights that a point was made with", "[interpolate]")
{
    Random random(1, "weights");
    for (int i = 0; i < 2000; ++i) {
        const Corners corners = randomCorners(random);
        const glm::vec3 weights = randomWeights(random);
        CHECK(distance(barycentric(corners, pointAt(corners, weights)), weights) < slenderRounding);
    }
}

TEST_CASE("Barycentrics outside are those of the closest point, also of a triangle without area", "[interpolate]")
{
    Random random(1, "closest");
    for (int i = 0; i < 4000; ++i) {
        const Corners corners = anyCorners(random, i);
        const glm::vec3 p = random.vec3(-2.0f, 2.0f);
        const grading::Corners exact { glm::dvec3(corners[0]), glm::dvec3(corners[1]), glm::dvec3(corners[2]) };
        const double closest
            = glm::distance(grading::pointAt(exact, grading::closestPoint(exact, glm::dvec3(p))), glm::dvec3(p));
        CHECK(distance(p, pointAt(corners, barycentric(corners, p)))
            == Approx(closest).margin(1e-5)); // of numbers up to 3
    }
}

TEST_CASE("Barycentrics follow their corners when these change places", "[interpolate]")
{
    Random random(1, "places");
    for (int i = 0; i < 1000; ++i) {
        const Corners c = randomCorners(random);
        const glm::vec3 p = random.vec3(-1.0f, 1.0f);
        const glm::vec3 bc = barycentric(c, p);
        CHECK(distance(barycentric({ c[1], c[2], c[0] }, p), { bc.y, bc.z, bc.x }) < slenderRounding);
        CHECK(distance(barycentric({ c[1], c[0], c[2] }, p), { bc.y, bc.x, bc.z }) < slenderRounding);
    }
}

TEST_CASE("Barycentrics stay when triangle and point are moved, turned and scaled together", "[interpolate]")
{
    Random random(1, "move");
    for (int i = 0; i < 1000; ++i) {
        const Corners corners = randomCorners(random);
        const glm::vec3 p = pointAt(corners, randomWeights(random));
        const glm::quat turn = glm::angleAxis(random.uniform(0.0f, 6.0f), random.direction());
        const float scale = std::pow(10.0f, random.uniform(-3.0f, 3.0f));
        const glm::vec3 shift = random.vec3(-1.0f, 1.0f);
        const auto move = [&](const glm::vec3& v) { return scale * (turn * v + shift); };
        CHECK(distance(barycentric({ move(corners[0]), move(corners[1]), move(corners[2]) }, move(p)),
                  barycentric(corners, p))
            < slenderRounding);
    }
}

TEST_CASE("An interpolated normal is unit and the weighted mean's direction", "[interpolate]")
{
    Random random(1, "normal");
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 n = random.direction();
        const auto nearby = [&] { return glm::normalize(n + 0.8f * random.direction()); };
        const glm::vec3 n0 = nearby(), n1 = nearby(), n2 = nearby(), bc = randomWeights(random);
        const glm::vec3 normal = interpolateNormal(n0, n1, n2, bc);
        const glm::dvec3 mean = static_cast<double>(bc.x) * glm::dvec3(n0) + static_cast<double>(bc.y) * glm::dvec3(n1)
            + static_cast<double>(bc.z) * glm::dvec3(n2);
        CHECK(std::abs(glm::length(glm::dvec3(normal)) - 1.0) < fewRoundings);
        CHECK(distance(normal, glm::normalize(mean)) < 1e-5); // the mean is 0.1 long or more
        CHECK(distance(interpolateNormal(n, n, n, bc), n) < fewRoundings);
        CHECK(distance(interpolateNormal(n0, n1, n2, { 0, 1, 0 }), n1) < fewRoundings);
    }
}

TEST_CASE("An interpolated normal is a number even where the normals cancel", "[interpolate]")
{
    const glm::vec3 n { 0, 0, 1 };
    CHECK(isFinite(interpolateNormal(n, -n, n, { 0.5f, 0.5f, 0.0f })));
    CHECK(isFinite(interpolateNormal(glm::vec3(0.0f), glm::vec3(0.0f), glm::vec3(0.0f), { 0.2f, 0.3f, 0.5f })));
}

TEST_CASE("Interpolated texture coordinates are the weighted sum, not clamped", "[interpolate]")
{
    Random random(1, "texture coordinates");
    for (int i = 0; i < 1000; ++i) {
        const glm::vec2 t0 = random.vec2(-2.0f, 2.0f), t1 = random.vec2(-2.0f, 2.0f), t2 = random.vec2(-2.0f, 2.0f);
        const glm::dvec3 bc { randomWeights(random) };
        const glm::dvec2 sum = bc.x * glm::dvec2(t0) + bc.y * glm::dvec2(t1) + bc.z * glm::dvec2(t2);
        CHECK(glm::distance(glm::dvec2(interpolateTexCoord(t0, t1, t2, bc)), sum) < fewRoundings);
        CHECK(interpolateTexCoord(t0, t1, t2, { 0, 0, 1 }) == t2);
    }
}
