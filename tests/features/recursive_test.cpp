#include "accel/counting_bvh.h"
#include "debug/cause.h"
#include "grading/oracle/random_scene.h"
#include "recursive.h"
#include "world.h"
#include <catch2/catch.hpp>

using namespace tests;
using grading::Random;

namespace {

constexpr int maxDepth = 6;
const glm::vec3 kd { 0.1f, 0.2f, 0.3f };

// No shading and no shadows: every surface shows the light's colour times its kd, and nothing else sends rays.
Features flat()
{
    return { .enableReflections = true, .enableTransparency = true };
}

void addLight(Scene& scene)
{
    scene.lights.emplace_back(PointLight { .position = { 0, 0, 0 }, .color = glm::vec3(1.0f) });
}

const Ray forward { .origin = { 0.3f, 0.2f, 0.0f }, .direction = { 0, 0, 1 } };

Scene facingMirrors(const glm::vec3& ks)
{
    Scene scene;
    addLight(scene);
    addPane(scene, { .kd = kd, .ks = ks }, 1.0f);
    addPane(scene, { .kd = kd, .ks = ks }, -1.0f);
    return scene;
}

// Panes one behind the other, each with a colour of its own.
Scene panes(int count, float alpha)
{
    Scene scene;
    addLight(scene);
    for (int i = 1; i <= count; ++i)
        addPane(scene, { .kd = kd * static_cast<float>(i), .transparency = alpha }, static_cast<float>(i));
    return scene;
}

// What a ray becomes.
accel::RayCounts countByKind(Scene scene, const Features& features, int depth = 0)
{
    World world(std::move(scene), features);
    const accel::CountingBVH counting(world.bvh);
    RenderState state { world.scene, world.features, counting, Sampler(1) };
    const debug::Watch watch;
    const accel::RayCounts before = accel::CountingBVH::rayCounts();
    (void)renderRay(state, forward, depth);
    return accel::CountingBVH::rayCounts() - before;
}

uint64_t countRays(Scene scene, const Features& features, int depth = 0)
{
    return countByKind(std::move(scene), features, depth).total();
}

glm::vec3 colorOf(Scene scene, const Features& features = flat(), int depth = 0)
{
    World world(std::move(scene), features);
    return renderRay(world.state, forward, depth);
}

// A ray that meets a surface from its front.
struct Incidence {
    Ray ray;
    HitInfo hit;
};

Incidence randomIncidence(Random& random)
{
    Incidence incidence {
        { random.vec3(-1.0f, 1.0f), random.uniform(0.5f, 2.0f) * random.direction(), random.uniform(0.1f, 2.0f) }, {}
    };
    incidence.hit.normal = random.direction();
    if (glm::dot(incidence.hit.normal, incidence.ray.direction) > 0.0f)
        incidence.hit.normal = -incidence.hit.normal;
    return incidence;
}

glm::dvec3 pointOf(const Ray& ray)
{
    return glm::dvec3(ray.origin) + static_cast<double>(ray.t) * glm::dvec3(ray.direction);
}

// How far the origin is from the surface, on the side that the normal points to.
double heightOver(const Incidence& incidence, const Ray& ray)
{
    return glm::dot(glm::dvec3(ray.origin) - pointOf(incidence.ray), glm::dvec3(incidence.hit.normal));
}

}

TEST_CASE("A reflected ray leaves at the angle at which the ray came, in its plane", "[recursive]")
{
    Random random(1, "reflected");
    for (int i = 0; i < 1000; ++i) {
        const Incidence incidence = randomIncidence(random);
        const Ray reflected = generateReflectionRay(incidence.ray, incidence.hit);
        const glm::dvec3 in = glm::normalize(glm::dvec3(incidence.ray.direction)), out { reflected.direction };
        const glm::dvec3 n { incidence.hit.normal };
        CHECK(std::abs(glm::length(out) - 1.0) < fewRoundings);
        CHECK(glm::dot(out, n) == Approx(-glm::dot(in, n)).margin(fewRoundings));
        CHECK(glm::distance(out - glm::dot(out, n) * n, in - glm::dot(in, n) * n) < fewRoundings);
        CHECK(reflected.t == FLT_MAX);
    }
}

TEST_CASE("A passthrough ray goes on in the ray's direction", "[recursive]")
{
    Random random(1, "passthrough");
    for (int i = 0; i < 1000; ++i) {
        const Incidence incidence = randomIncidence(random);
        const Ray passthrough = generatePassthroughRay(incidence.ray, incidence.hit);
        const glm::dvec3 in { incidence.ray.direction }, out { passthrough.direction };
        CHECK(glm::distance(glm::normalize(in), glm::normalize(out)) < fewRoundings);
        CHECK(passthrough.t == FLT_MAX);
    }
}

TEST_CASE("New rays start a little off the surface, on the side that they are sent to", "[recursive]")
{
    Random random(1, "offset");
    for (int i = 0; i < 1000; ++i) {
        const Incidence incidence = randomIncidence(random);
        const Ray reflected = generateReflectionRay(incidence.ray, incidence.hit);
        const Ray passthrough = generatePassthroughRay(incidence.ray, incidence.hit);
        CHECK(heightOver(incidence, reflected) > 5e-6); // dozens of roundings of a coordinate of about 1
        CHECK(heightOver(incidence, passthrough) < -5e-6);
        CHECK(distance(reflected.origin, pointOf(incidence.ray)) < 1e-3); // cannot be seen
        CHECK(distance(passthrough.origin, pointOf(incidence.ray)) < 1e-3);
    }
}

TEST_CASE("Neither new ray meets its own surface again, near the origin or far from it", "[recursive]")
{
    for (const float at : { 1e-3f, 1.0f, 1e3f }) {
        Scene scene;
        const glm::vec3 corner { at, -at, at };
        addParallelogram(scene, {}, corner - glm::vec3(4, 4, 0), { 8, 0, 1 }, { 0, 8, 2 });
        World world(std::move(scene));
        Random random(1, "own surface");
        for (int i = 0; i < 500; ++i) {
            const glm::vec3 target = corner + random.vec3(-1.0f, 1.0f);
            Ray ray { corner + 3.0f * random.direction(), {} };
            ray.direction = glm::normalize(target - ray.origin);
            HitInfo hit, again;
            if (!world.bvh.intersect(world.state, ray, hit))
                continue;
            Ray reflected = generateReflectionRay(ray, hit), passthrough = generatePassthroughRay(ray, hit);
            CHECK_FALSE(world.bvh.intersect(world.state, reflected, again));
            CHECK_FALSE(world.bvh.intersect(world.state, passthrough, again));
        }
    }
}

TEST_CASE("A ray between facing mirrors is traced until depth 6, exactly", "[recursive]")
{
    for (int depth = 0; depth <= maxDepth; ++depth)
        CHECK(countRays(facingMirrors(glm::vec3(1.0f)), flat(), depth) == static_cast<uint64_t>(maxDepth - depth + 1));
}

TEST_CASE("A ray through clear panes is traced until depth 6, exactly", "[recursive]")
{
    for (int depth = 0; depth <= maxDepth; ++depth)
        CHECK(countRays(panes(10, 0.0f), flat(), depth) == static_cast<uint64_t>(maxDepth - depth + 1));
}

TEST_CASE("A surface that is both splits a ray in two at each depth", "[recursive]")
{
    Scene scene;
    for (int i = 1; i <= 10; ++i) {
        addPane(scene, { .kd = kd, .ks = kd, .transparency = 0.5f }, static_cast<float>(i));
        addPane(scene, { .kd = kd, .ks = kd, .transparency = 0.5f }, static_cast<float>(-i));
    }
    CHECK(countRays(std::move(scene), flat()) == (1u << (maxDepth + 1)) - 1); // a full binary tree of 7 levels
}

TEST_CASE("Rays are not sent where they cannot matter", "[recursive]")
{
    CHECK(countRays(facingMirrors(glm::vec3(0.0f)), flat()) == 1);
    CHECK(countRays(panes(3, 1.0f), flat()) == 1);
    CHECK(countRays(facingMirrors(kd), { .enableTransparency = true }) == 1);
    CHECK(countRays(panes(3, 0.5f), { .enableReflections = true }) == 1);
}

TEST_CASE("Facing mirrors show the geometric series of their reflectance", "[recursive]")
{
    for (const float reflectance : { 0.5f, 0.9f, 1.0f }) {
        glm::dvec3 sum { 0.0 };
        for (int depth = 0; depth <= maxDepth; ++depth)
            sum += std::pow(static_cast<double>(reflectance), depth) * glm::dvec3(kd);
        CHECK(distance(colorOf(facingMirrors(glm::vec3(reflectance))), sum) < fewRoundings);
    }
}

TEST_CASE("Rays follow one another as often as the features allow", "[recursive]")
{
    for (uint32_t most = 0; most <= maxDepth; ++most) {
        Features features = flat();
        features.extra.maxDepth = most;
        CHECK(countRays(facingMirrors(glm::vec3(1.0f)), features) == most + 1);
        CHECK(countRays(panes(10, 0.0f), features) == most + 1);
    }
}

TEST_CASE("Rays are counted by why they are traced", "[recursive]")
{
    Features features = flat();
    features.enableShadows = true;
    features.enableTransparency = false; // a shadow ray ends at the first surface: one a light and hit
    const accel::RayCounts counts = countByKind(facingMirrors(glm::vec3(1.0f)), features);
    CHECK(counts.camera == 1);
    CHECK(counts.bounced == maxDepth);
    CHECK(counts.shadow == maxDepth + 1);
    CHECK(counts.total() == counts.camera + counts.bounced + counts.shadow);
}

TEST_CASE("A mirror tints by its ks, channel by channel", "[recursive]")
{
    const glm::vec3 ks { 1.0f, 0.5f, 0.0f };
    Scene scene;
    addLight(scene);
    addPane(scene, { .ks = ks }, 1.0f); // kd black: all light is mirrored
    addPane(scene, { .kd = glm::vec3(0.8f) }, -1.0f);
    CHECK(distance(colorOf(std::move(scene)), 0.8 * glm::dvec3(ks)) < fewRoundings);
}

TEST_CASE("Transparency blends: alpha of the surface, the rest from behind", "[recursive]")
{
    for (const float alpha : { 0.0f, 0.2f, 0.5f, 1.0f }) {
        CAPTURE(alpha);
        const double a { alpha };
        glm::dvec3 expected { 0.0 }; // behind the last pane
        for (int i = 4; i >= 1; --i)
            expected = a * glm::dvec3(kd * static_cast<float>(i)) + (1.0 - a) * expected;
        CHECK(distance(colorOf(panes(4, alpha)), expected) < fewRoundings);
    }
}

TEST_CASE("A clear pane shows what is behind it, and the seventh its own colour", "[recursive]")
{
    Scene two = panes(2, 0.0f);
    two.meshes.back().material.transparency = 1.0f;
    CHECK(distance(colorOf(std::move(two)), glm::dvec3(kd * 2.0f)) < fewRoundings);
    CHECK(distance(colorOf(panes(10, 0.0f)), glm::dvec3(kd * 7.0f)) < fewRoundings);
}

TEST_CASE("The mirrored light is added before the blend", "[recursive]")
{
    constexpr double alpha = 0.25;
    Scene scene;
    addLight(scene);
    addPane(scene, { .kd = kd, .ks = glm::vec3(0.5f), .transparency = static_cast<float>(alpha) }, 1.0f);
    addPane(scene, { .kd = glm::vec3(0.6f) }, -1.0f);
    addPane(scene, { .kd = glm::vec3(0.9f) }, 2.0f);
    const glm::dvec3 expected = (glm::dvec3(kd) + 0.5 * 0.6) * alpha + 0.9 * (1.0 - alpha);
    CHECK(distance(colorOf(std::move(scene)), expected) < fewRoundings);
}

TEST_CASE("A ray that meets nothing is black, several are averaged", "[recursive]")
{
    World world(panes(1, 1.0f), flat());
    const Ray away { .origin = { 0, 0, 0 }, .direction = { 0, 0, -1 } };
    CHECK(renderRay(world.state, away) == glm::vec3(0.0f));
    const std::array<Ray, 4> rays { forward, away, forward, forward };
    CHECK(distance(renderRays(world.state, rays), 0.75 * glm::dvec3(kd)) < fewRoundings);
    CHECK(renderRays(world.state, {}) == glm::vec3(0.0f));
}
