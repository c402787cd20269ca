#include "grading/oracle/brute_force.h"
#include "grading/oracle/random_scene.h"
#include "light.h"
#include "shading.h"
#include "world.h"
#include <catch2/catch.hpp>

using namespace tests;
using grading::Random;

namespace {

// The shaded point is the origin, seen from above, on a surface that faces up.
const Ray view { .origin = { 0, 0, 1 }, .direction = { 0, 0, -1 }, .t = 1.0f };

HitInfo floorHit(const glm::vec3& kd = glm::vec3(1.0f))
{
    HitInfo hit {};
    hit.normal = { 0, 0, 1 };
    hit.material.kd = kd;
    return hit;
}

const glm::vec3 kd { 0.9f, 0.5f, 0.2f }; // of what stands between point and light
const glm::vec3 lightColor { 1.0f, 0.8f, 0.6f };
const glm::vec3 above { 0.3f, -0.2f, 8.0f };

Scene panes(int count, float alpha)
{
    Scene scene;
    addPane(scene, {}, 0.0f); // the floor itself
    for (int i = 1; i <= count; ++i)
        addPane(scene, { .kd = kd, .transparency = alpha }, static_cast<float>(i));
    return scene;
}

const SegmentLight segment { { -2, 1, 1 }, { 3, 0, 2 }, { 1, 0, 0.5f }, { 0, 1, 0.25f } };
const ParallelogramLight parallelogram { { -1, -1, 2 }, { 3, 0, 0.5f }, { 0.5f, 2, 0 }, { 1, 0, 0 }, { 0, 1, 0 },
    { 0, 0, 1 }, { 1, 1, 1 } };

glm::dvec3 pointOf(const SegmentLight& light, double s)
{
    return glm::dvec3(light.endpoint0) + s * glm::dvec3(light.endpoint1 - light.endpoint0);
}

glm::dvec3 colorOf(const SegmentLight& light, double s)
{
    return (1.0 - s) * glm::dvec3(light.color0) + s * glm::dvec3(light.color1);
}

glm::dvec3 pointOf(const ParallelogramLight& light, const glm::dvec2& s)
{
    return glm::dvec3(light.v0) + s.x * glm::dvec3(light.edge01) + s.y * glm::dvec3(light.edge02);
}

glm::dvec3 colorOf(const ParallelogramLight& light, const glm::dvec2& s)
{
    return (1.0 - s.x) * (1.0 - s.y) * glm::dvec3(light.color0) + s.x * (1.0 - s.y) * glm::dvec3(light.color1)
        + (1.0 - s.x) * s.y * glm::dvec3(light.color2) + s.x * s.y * glm::dvec3(light.color3);
}

// What the white floor sends back of a light at a place.
glm::dvec3 lambertAt(const glm::dvec3& place, const glm::dvec3& color)
{
    return color * std::max(glm::normalize(place).z, 0.0);
}

constexpr Features shaded { .enableShading = true };
constexpr Features shadowed { .enableShading = true, .enableShadows = true };

// The mean of n samples is off by more than five standard deviations once in two million fixed seeds; samples of
// colours in [0, 1] deviate by half at most.
constexpr uint32_t manySamples = 40'000;
constexpr double fiveDeviations = 5.0 * 0.5 / 200.0;

}

TEST_CASE("A sample of a segment light lies at its fraction, with the colour of the place", "[light]")
{
    Random random(1, "segment");
    for (int i = 0; i < 500; ++i) {
        const float s = i == 0 ? 0.0f : random.uniform();
        glm::vec3 position, color;
        sampleSegmentLight(s, segment, position, color);
        CHECK(distance(position, pointOf(segment, static_cast<double>(s))) < fewRoundings);
        CHECK(distance(color, colorOf(segment, static_cast<double>(s))) < fewRoundings);
    }
}

TEST_CASE("A sample of a parallelogram light lies on it, with the bilinear colour of the place", "[light]")
{
    Random random(1, "parallelogram");
    for (int i = 0; i < 500; ++i) {
        const glm::vec2 s = random.vec2();
        glm::vec3 position, color;
        sampleParallelogramLight(s, parallelogram, position, color);
        CHECK(distance(position, pointOf(parallelogram, glm::dvec2(s))) < fewRoundings);
        CHECK(distance(color, colorOf(parallelogram, glm::dvec2(s))) < fewRoundings);
    }
}

TEST_CASE("A corner of a parallelogram light has the colour that bears its number", "[light]")
{
    const std::array<std::pair<glm::vec2, glm::vec3>, 4> corners { { { { 0, 0 }, parallelogram.color0 },
        { { 1, 0 }, parallelogram.color1 }, { { 0, 1 }, parallelogram.color2 }, { { 1, 1 }, parallelogram.color3 } } };
    for (const auto& [sample, expected] : corners) {
        glm::vec3 position, color;
        sampleParallelogramLight(sample, parallelogram, position, color);
        CHECK(color == expected);
    }
}

TEST_CASE("An opaque pane hides the light, unless it lies behind the light or shadows are off", "[light]")
{
    World world(panes(1, 1.0f), shadowed);
    const auto isVisible = [&](const glm::vec3& light) {
        return visibilityOfLightSampleBinary(world.state, light, lightColor, view, floorHit());
    };
    CHECK_FALSE(isVisible(above));
    CHECK(isVisible({ 0.3f, -0.2f, 0.9f }));
    CHECK(visibilityOfLightSample(world.state, above, lightColor, view, floorHit()) == glm::vec3(0.0f));
    world.features.enableShadows = false;
    CHECK(isVisible(above));
    CHECK(visibilityOfLightSample(world.state, above, lightColor, view, floorHit()) == lightColor);
}

TEST_CASE("A surface does not shadow itself, at any angle of the light", "[light]")
{
    World world(panes(0, 1.0f), shadowed);
    for (double angle = 0.01; angle < 3.13; angle += 0.01) {
        const glm::vec3 light { 3.0 * std::cos(angle), 0.5, 3.0 * std::sin(angle) };
        CHECK(visibilityOfLightSampleBinary(world.state, light, lightColor, view, floorHit()));
        CHECK(visibilityOfLightSampleTransparency(world.state, light, lightColor, view, floorHit()) == lightColor);
    }
}

TEST_CASE("Visibility in random scenes is what brute force finds", "[light]")
{
    Random random(1, "visibility");
    Scene scene;
    grading::addTriangles(scene, random, 40);
    grading::addSpheres(scene, random, 2);
    World world(std::move(scene), shadowed);
    std::array<int, 2> count {};
    for (int i = 0; i < 3000; ++i) {
        Ray ray { 3.0f * random.direction(), {} };
        ray.direction = glm::normalize(random.vec3(-1.0f, 1.0f) - ray.origin);
        const grading::SceneHit hit = grading::closestHit(world.scene, ray);
        if (!hit.isHit || !hit.isClear || !hit.mesh)
            continue;
        HitInfo info {};
        info.normal = hit.normal;
        ray.t = static_cast<float>(hit.t);
        const glm::dvec3 point = glm::dvec3(ray.origin) + hit.t * glm::dvec3(ray.direction);
        const glm::vec3 light = random.vec3(-2.0f, 2.0f);
        // Whether it depends on how far the shadow ray keeps from both ends: then either answer is right.
        const glm::dvec3 shortest = 2e-3 * glm::normalize(glm::dvec3(light) - point);
        const bool nearly = grading::isBlocked(world.scene, point + 1e-3 * hit.normal, glm::dvec3(light) - shortest);
        const bool wholly = grading::isBlocked(world.scene, point + 1e-6 * hit.normal, glm::dvec3(light));
        if (nearly != wholly)
            continue;
        ++count[wholly];
        CHECK(visibilityOfLightSampleBinary(world.state, light, lightColor, ray, info) == !wholly);
    }
    CHECK(count[0] > 50); // both are met often
    CHECK(count[1] > 50);
}

TEST_CASE("Each pane multiplies the light by kd * (1 - alpha)", "[light]")
{
    for (const float alpha : { 0.0f, 0.5f, 1.0f }) {
        for (const int count : { 0, 1, 2, 5 }) {
            CAPTURE(alpha, count);
            World world(
                panes(count, alpha), { .enableShading = true, .enableShadows = true, .enableTransparency = true });
            const glm::dvec3 left = glm::pow(glm::dvec3(kd) * (1.0 - static_cast<double>(alpha)), glm::dvec3(count));
            CHECK(distance(visibilityOfLightSampleTransparency(world.state, above, lightColor, view, floorHit()),
                      left * glm::dvec3(lightColor))
                < fewRoundings);
            CHECK(visibilityOfLightSample(world.state, above, lightColor, view, floorHit())
                == visibilityOfLightSampleTransparency(world.state, above, lightColor, view, floorHit()));
        }
    }
}

TEST_CASE("The proposed formula leaves light * (kd * alpha + 1 - alpha), and nothing behind an opaque pane", "[light]")
{
    for (const float alpha : { 0.0f, 0.5f, 1.0f }) {
        CAPTURE(alpha);
        World world(panes(1, alpha), { .enableShading = true, .enableShadows = true, .enableTransparency = true });
        world.features.extra.enableProposedShadowFormula = true;
        const double a { alpha };
        const glm::dvec3 left = a == 1.0 ? glm::dvec3(0.0) : glm::dvec3(kd) * a + (1.0 - a);
        CHECK(distance(visibilityOfLightSampleTransparency(world.state, above, lightColor, view, floorHit()),
                  left * glm::dvec3(lightColor))
            < fewRoundings);
    }
}

TEST_CASE("A texture colours the light that goes through its surface", "[light]")
{
    Image green(1, 1);
    green.set_pixel(0, glm::vec3(0, 1, 0));
    Scene scene = panes(1, 0.5f);
    scene.meshes.back().material.kdTexture = &green;
    World world(std::move(scene), { .enableShadows = true, .enableTextureMapping = true, .enableTransparency = true });
    CHECK(distance(
              visibilityOfLightSampleTransparency(world.state, above, glm::vec3(1.0f), view, floorHit()), { 0, 0.5, 0 })
        < fewRoundings);
}

TEST_CASE("A point light gives the shading from its direction, at any distance but 0 alike", "[light]")
{
    World world({}, shaded);
    Random random(1, "point light");
    for (int i = 0; i < 300; ++i) {
        const PointLight light { random.uniform(0.1f, 10.0f) * random.direction(), random.color() };
        const glm::dvec3 expected = lambertAt(glm::dvec3(light.position), glm::dvec3(light.color));
        CHECK(distance(computeContributionPointLight(world.state, light, view, floorHit()), expected) < fewRoundings);
    }
    const PointLight inThePoint { view.origin + view.t * view.direction, lightColor }; // it has no direction
    CHECK(computeContributionPointLight(world.state, inThePoint, view, floorHit()) == glm::vec3(0.0f));
}

TEST_CASE("An area light without extent is a point light, for any number of samples", "[light]")
{
    World world({}, shaded);
    const glm::vec3 none { 0.0f };
    const SegmentLight point { above, above, lightColor, lightColor };
    const ParallelogramLight place { above, none, none, lightColor, lightColor, lightColor, lightColor };
    const glm::dvec3 expected = lambertAt(glm::dvec3(above), glm::dvec3(lightColor));
    for (const uint32_t numSamples : { 1u, 2u, 3u, 16u }) {
        const auto segmentMean = computeContributionSegmentLight(world.state, point, view, floorHit(), numSamples);
        const auto mean = computeContributionParallelogramLight(world.state, place, view, floorHit(), numSamples);
        CHECK(distance(segmentMean, expected) < fewRoundings);
        CHECK(distance(mean, expected) < fewRoundings);
    }
}

TEST_CASE("The mean over a segment light approaches the integral", "[light]")
{
    World world({}, shaded);
    glm::dvec3 integral { 0.0 };
    constexpr int steps = 1000;
    for (int i = 0; i < steps; ++i) {
        const double s = (i + 0.5) / steps;
        integral += lambertAt(pointOf(segment, s), colorOf(segment, s)) / static_cast<double>(steps);
    }
    CHECK(distance(computeContributionSegmentLight(world.state, segment, view, floorHit(), manySamples), integral)
        < fiveDeviations);
}

TEST_CASE("The mean over a parallelogram light approaches the integral, also half in shadow", "[light]")
{
    const bool withBlocker = GENERATE(false, true);
    Scene scene;
    if (withBlocker) // all of x + 2y > 0: part of the light
        addParallelogram(scene, {}, { -20, 10, 0.5f }, { 40, -20, 0 }, { 20, 40, 0 });
    World world(std::move(scene), shadowed);
    glm::dvec3 integral { 0.0 };
    constexpr int steps = 300;
    for (int j = 0; j < steps; ++j) {
        for (int i = 0; i < steps; ++i) {
            const glm::dvec2 s = (glm::dvec2(i, j) + 0.5) / static_cast<double>(steps);
            const glm::dvec3 place = pointOf(parallelogram, s);
            if (!withBlocker || place.x + 2.0 * place.y < 0.0)
                integral += lambertAt(place, colorOf(parallelogram, s)) / static_cast<double>(steps * steps);
        }
    }
    CHECK(glm::length(integral) > 0.1);
    CHECK(distance(computeContributionParallelogramLight(world.state, parallelogram, view, floorHit(), manySamples),
              integral)
        < fiveDeviations);
}

TEST_CASE("The lights of a scene add up, area lights with the samples that the features say", "[light]")
{
    Scene scene;
    scene.lights = { PointLight { above, lightColor }, PointLight { { 1, 0, 1 }, lightColor }, segment, parallelogram };
    World world(std::move(scene), { .enableShading = true, .numShadowSamples = 64 });
    const glm::vec3 sum = computeLightContribution(world.state, view, floorHit());
    world.state.sampler = Sampler(1);
    glm::vec3 expected
        = computeContributionPointLight(world.state, std::get<PointLight>(world.scene.lights[0]), view, floorHit());
    expected
        += computeContributionPointLight(world.state, std::get<PointLight>(world.scene.lights[1]), view, floorHit());
    expected += computeContributionSegmentLight(world.state, segment, view, floorHit(), 64);
    expected += computeContributionParallelogramLight(world.state, parallelogram, view, floorHit(), 64);
    CHECK(sum == expected);
}

TEST_CASE("Two estimates of an area light differ: each sample has its own random numbers", "[light]")
{
    World world({}, shaded);
    const auto estimate
        = [&] { return computeContributionParallelogramLight(world.state, parallelogram, view, floorHit(), 4); };
    CHECK(estimate() != estimate());
}
