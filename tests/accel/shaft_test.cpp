#include "accel/counting_bvh.h"
#include "accel/light_shaft.h"
#include "accel/recording_bvh.h"
#include "random_triangles.h"
#include "worker/library_bvh.h"
#include "world.h"
#include <algorithm>
#include <catch2/catch.hpp>

using accel::LightShaft;
using accel::WideTree;
using accel::wide::Shaft;
using grading::Random;

namespace {

// Along a random axis, forward or backward.
Shaft randomShaft(const glm::vec3& point, float width, float length, Random& random)
{
    const auto z = static_cast<unsigned>(random.integer(0, 2));
    Shaft shaft { { point.x, point.y, point.z }, { (z + 1) % 3, (z + 2) % 3, z }, {}, {}, length };
    for (int i = 0; i < 2; ++i) {
        shaft.least[i] = random.uniform() * (1.9f - width) - 0.95f;
        shaft.largest[i] = shaft.least[i] + width * random.uniform();
    }
    if (random.integer(0, 1) == 0)
        shaft.end = -length;
    return shaft;
}

// One of its segments, often one along its rim, of any length.
Ray rayIn(const Shaft& shaft, Random& random)
{
    const auto part = [&] { return std::array { 0.0f, 1.0f, random.uniform() }[random.integer(0, 2)]; };
    Ray ray { { shaft.point[0], shaft.point[1], shaft.point[2] }, {} };
    for (int i = 0; i < 2; ++i)
        ray.direction[shaft.axes[i]] = glm::mix(shaft.least[i], shaft.largest[i], part()) * shaft.end;
    ray.direction[shaft.axes[2]] = shaft.end;
    ray.t = part();
    return ray;
}

// No kernel may call a shaft clear in which a ray meets something. How many it calls clear, of those that look so.
class Clearness {
public:
    void check(const WideTree& tree, const Shaft& shaft, Random& random)
    {
        std::vector<Ray> rays;
        for (int i = 0; i < 60; ++i)
            rays.push_back(rayIn(shaft, random));
        const bool looksClear = std::ranges::none_of(rays, [&](const Ray& ray) { return tree.occluded(ray); });
        for (const accel::wide::Kernel* kernel : accel::wide::kernels()) {
            const bool isClear = tree.isClear(shaft, *kernel);
            CAPTURE(kernel->name);
            REQUIRE((looksClear || !isClear));
            m_numClear += isClear;
            m_numLooks += looksClear;
        }
    }

    [[nodiscard]] double partFound() const { return m_numClear / m_numLooks; }

private:
    double m_numClear = 0, m_numLooks = 0;
};

glm::vec3 pointOn(const WideTree::Triangle& triangle, Random& random)
{
    const float u = random.uniform(), v = random.uniform() * (1.0f - u);
    return triangle[0] + u * (triangle[1] - triangle[0]) + v * (triangle[2] - triangle[0]);
}

}

TEST_CASE("Shaft that is clear has no ray that meets a triangle, and most that have none are found", "[shaft]")
{
    Random random(1, "shaft");
    for (const int count : { 1, 12, 40, 300, 3000 }) {
        for (const float size : { 0.02f, 0.3f, 2.0f }) {
            const WideTree tree(tests::randomTriangles(random, count, size));
            Clearness clearness;
            for (int i = 0; i < 200; ++i) {
                const float width = std::array { 0.0f, 0.01f, 0.3f }[i % 3];
                clearness.check(
                    tree, randomShaft(random.vec3(-2.0f, 2.0f), width, 3.0f * random.uniform() + 0.1f, random), random);
            }
            CAPTURE(count, size);
            CHECK(clearness.partFound() > 0.9); // sixty rays miss what is small
        }
    }
}

TEST_CASE("Shaft that begins on a triangle, a little above it or below, has no ray that meets one", "[shaft]")
{
    Random random(1, "from surfaces");
    for (const float distance : { 0.0f, 10.0f, 1e4f }) {
        auto triangles = tests::randomTriangles(random, 30, 0.5f);
        for (WideTree::Triangle& triangle : triangles)
            for (glm::vec3& corner : triangle)
                corner += distance;
        const WideTree tree(triangles);
        Clearness clearness;
        for (int i = 0; i < 2000; ++i) {
            const WideTree::Triangle& triangle = triangles[static_cast<std::size_t>(random.integer(0, 29))];
            const glm::vec3 point = pointOn(triangle, random);
            const glm::vec3 normal = glm::normalize(glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]));
            const float lift = std::array { 0.0f, 0x1p-23f, 0x1p-15f, -0x1p-15f }[i % 4] * (1.0f + distance);
            clearness.check(tree, randomShaft(point + lift * normal, 0.1f, 1.0f, random), random);
        }
        CAPTURE(distance);
        CHECK(clearness.partFound() > 0.95);
    }
}

TEST_CASE("Shaft among triangles that are seen edge-on: all but their roundings lies in its plane", "[shaft]")
{
    Random random(1, "edge-on");
    Clearness clearness;
    for (int i = 0; i < 20000; ++i) {
        const glm::vec3 point = random.vec3(-1.0f, 1.0f), across = random.vec3(-1.0f, 1.0f);
        const Shaft shaft = randomShaft(point, i % 2 == 0 ? 0.0f : 0.1f, 1.0f, random);
        const glm::vec3 along = rayIn(shaft, random).direction;
        const auto corner = [&] {
            return point + 3.0f * (2.0f * random.uniform() - 1.0f) * along + 0.5f * (random.uniform() - 0.2f) * across;
        };
        clearness.check(WideTree(std::vector { WideTree::Triangle { corner(), corner(), corner() } }), shaft, random);
    }
    CHECK(clearness.partFound() > 0.05); // where all is close to the margins
}

TEST_CASE("Shaft that is clear is so at any scale, tiny and huge", "[shaft]")
{
    Random random(1, "scale");
    for (int exponent = -60; exponent <= 60; exponent += 4) {
        const float scale = std::ldexp(1.0f, exponent);
        auto triangles = tests::randomTriangles(random, 12, 0.5f);
        for (WideTree::Triangle& triangle : triangles)
            for (glm::vec3& corner : triangle)
                corner *= scale;
        const WideTree tree(triangles);
        CAPTURE(exponent);
        Clearness clearness;
        for (int i = 0; i < 500; ++i)
            clearness.check(
                tree, randomShaft(scale * random.vec3(-1.0f, 1.0f), 0.1f, scale * random.uniform(), random), random);
        if (std::abs(exponent) <= 20)
            CHECK(clearness.partFound() > 0.9);
    }
}

TEST_CASE("Shaft, what is beside it, behind its beginning, or beyond its end, does not matter", "[shaft]")
{
    const auto pane = [](float left, float right, float z) {
        return WideTree::Triangle { glm::vec3(left, -5.0f, z), { left, 5.0f, z }, { right, 0.0f, z } };
    };
    const auto isClear = [](const std::vector<WideTree::Triangle>& triangles) {
        const Shaft shaft { {}, { 0, 1, 2 }, { -0.5f, -0.5f }, { 0.5f, 0.5f }, 2.0f };
        const WideTree tree(triangles);
        return std::ranges::all_of(
            accel::wide::kernels(), [&](const auto* kernel) { return tree.isClear(shaft, *kernel); });
    };
    CHECK(isClear({}));
    CHECK(isClear({ pane(-9.0f, 9.0f, -0.001f) }));
    CHECK(isClear({ pane(-9.0f, 9.0f, 2.001f) }));
    CHECK(isClear({ pane(0.51f, 9.0f, 1.0f) }));
    CHECK(isClear({ pane(-9.0f, 9.0f, -0.001f), pane(-9.0f, 9.0f, 2.001f), pane(0.51f, 9.0f, 1.0f) }));
    CHECK_FALSE(isClear({ pane(-9.0f, 9.0f, 0.001f) }));
    CHECK_FALSE(isClear({ pane(-9.0f, 9.0f, 1.999f) }));
    CHECK_FALSE(isClear({ pane(0.49f, 9.0f, 1.0f) }));
}

TEST_CASE("Shaft to a light, clear for a ray only if that meets neither triangle nor sphere", "[shaft]")
{
    Random random(1, "light");
    Scene scene;
    for (int i = 0; i < 6; ++i) {
        const auto edge = [&] { return random.vec3(-0.5f, 0.5f); };
        tests::addParallelogram(scene, {}, random.vec3(-1.0f, 1.0f), edge(), edge());
        scene.spheres.push_back({ random.vec3(-1.0f, 1.0f), 0.2f, {} });
    }
    const tests::World world(scene);
    const worker::LibraryBVH bvh(world.scene, world.features);
    RenderState state { world.scene, world.features, bvh, Sampler(1) };
    LightShaft shaft;
    int numClear = 0, numOpen = 0;
    for (int i = 0; i < 3000; ++i) {
        const ParallelogramLight light { random.vec3(-2.0f, 2.0f), 0.3f * random.vec3(-1.0f, 1.0f),
            0.3f * random.vec3(-1.0f, 1.0f), {}, {}, {}, {} };
        const SegmentLight edge { light.v0, light.v0 + light.edge01, {}, {} };
        glm::vec3 point = random.vec3(-1.0f, 1.0f);
        if (i % 3 == 0) { // just above a sphere
            const Sphere& sphere = scene.spheres[static_cast<std::size_t>(i % 6)];
            point = sphere.center + sphere.radius * (1.0f + 0x1p-15f) * glm::normalize(point);
        }
        if (i % 10 == 0) // else as it is after the others
            shaft = LightShaft();
        i % 2 == 0 ? shaft.aimAt(light, 16) : shaft.aimAt(edge, 16);
        for (int j = 0; j < 16; ++j) {
            const glm::vec3 position
                = light.v0 + random.uniform() * light.edge01 + (i % 2 == 0 ? random.uniform() : 0.0f) * light.edge02;
            const float distance = glm::length(position - point);
            const Ray ray { point, (position - point) / distance, distance * (1.0f - 0x1p-15f) };
            const bool isOpen = !bvh.isOccluded(state, ray);
            const bool isClear = shaft.isClearFor(state, bvh, ray);
            REQUIRE((isOpen || !isClear));
            numClear += isClear;
            numOpen += isOpen;
        }
    }
    CHECK(numClear > numOpen / 4); // not always somebody looks
}

TEST_CASE("Shaft, clear for no ray that leaves from elsewhere, leads past the light, or farther", "[shaft]")
{
    const tests::World world;
    const worker::LibraryBVH bvh(world.scene, world.features);
    const RenderState state { world.scene, world.features, bvh, Sampler(1) };
    const SegmentLight light { { -1.0f, 0.0f, 4.0f }, { 1.0f, 0.0f, 4.0f }, {}, {} };
    const Ray ray { glm::vec3(0.0f), { 0.0f, 0.0f, 1.0f }, 4.0f };
    LightShaft shaft;
    CHECK_FALSE(shaft.isClearFor(state, bvh, ray)); // not aimed
    shaft.aimAt(light, 16);
    CHECK(shaft.isClearFor(state, bvh, ray));
    CHECK_FALSE(shaft.isClearFor(state, bvh, { { 0.0f, 0.1f, 0.0f }, ray.direction, 4.0f }));
    CHECK_FALSE(shaft.isClearFor(state, bvh, { ray.origin, { 0.0f, 0.001f, 1.0f }, 4.0f }));
    CHECK_FALSE(shaft.isClearFor(state, bvh, { ray.origin, { 0.26f, 0.0f, 1.0f }, 4.0f }));
    CHECK_FALSE(shaft.isClearFor(state, bvh, { ray.origin, { 0.0f, 0.0f, -1.0f }, 4.0f }));
    CHECK_FALSE(shaft.isClearFor(state, bvh, { ray.origin, ray.direction, 4.001f }));
    CHECK(shaft.isClearFor(state, bvh, { ray.origin, { 0.24f, 0.0f, 1.0f }, 3.9f }));
    shaft.aimAt(light, 1); // one ray is traced as soon
    CHECK_FALSE(shaft.isClearFor(state, bvh, ray));
}

TEST_CASE("Shaft, clear in the tree where it was looked at, and in no other", "[shaft]")
{
    Scene blocked;
    tests::addPane(blocked, {}, 2.0f);
    const tests::World world, behindPane(blocked);
    const worker::LibraryBVH nothing(world.scene, world.features), pane(behindPane.scene, world.features);
    const RenderState state { world.scene, world.features, nothing, Sampler(1) };
    const SegmentLight light { { -1.0f, 0.0f, 4.0f }, { 1.0f, 0.0f, 4.0f }, {}, {} };
    const Ray ray { glm::vec3(0.0f), { 0.0f, 0.0f, 1.0f }, 4.0f };
    LightShaft shaft;
    shaft.aimAt(light, 16);
    CHECK(shaft.isClearFor(state, nothing, ray));
    CHECK_FALSE(shaft.isClearFor(state, pane, ray));
}

TEST_CASE("Shaft, rays that it answers are recorded by nobody and counted apart from those that are traced", "[shaft]")
{
    const tests::World world;
    worker::LibraryBVH bvh(world.scene, world.features);
    accel::RecordedRays recorded;
    accel::RecordingBVH recording(bvh, recorded);
    const accel::CountingBVH counting(recording);
    LightShaft shaft;
    RenderState state { world.scene, world.features, counting, Sampler(1) };
    state.shaft = &shaft;
    const SegmentLight light { { -1.0f, 0.0f, 4.0f }, { 1.0f, 0.0f, 4.0f }, {}, {} };
    shaft.aimAt(light, 16);
    const accel::RayCounts before = accel::CountingBVH::rayCounts();
    for (const glm::vec3& way :
        { glm::vec3(0.0f, 0.0f, 4.0f), glm::vec3(0.5f, 0.0f, 4.0f), glm::vec3(5.0f, 0.0f, 4.0f) })
        CHECK_FALSE(counting.isOccluded(state, { glm::vec3(0.0f), way, 1.0f }));
    const accel::RayCounts counts = accel::CountingBVH::rayCounts() - before;
    CHECK(counts.clear == 2);
    CHECK(counts.shadow == 1); // past the light
    CHECK(recorded.numRays() == 1);
}

TEST_CASE("Shaft, seldom looked at where it is never clear, and again where it is", "[shaft]")
{
    Scene scene;
    tests::addParallelogram(scene, {}, { -1.0f, -1.0f, 2.0f }, { 2.0f, 0.0f, 0.0f }, { 0.0f, 2.0f, 0.0f });
    const tests::World world(scene);
    const worker::LibraryBVH bvh(world.scene, world.features);
    const RenderState state { world.scene, world.features, bvh, Sampler(1) };
    const SegmentLight light { { -0.1f, 0.0f, 4.0f }, { 0.1f, 0.0f, 4.0f }, {}, {} };
    LightShaft shaft;
    const auto isClearFrom = [&](float x) {
        shaft.aimAt(light, 4);
        const glm::vec3 point(x, 0.0f, 0.0f), way = glm::vec3(0.0f, 0.0f, 4.0f) - point;
        return shaft.isClearFor(state, bvh, { point, way, 1.0f });
    };
    for (int i = 0; i < 100; ++i)
        CHECK_FALSE(isClearFrom(0.0f));
    int numTimes = 0;
    while (!isClearFrom(3.5f))
        REQUIRE(++numTimes < 20);
    CHECK_FALSE(isClearFrom(0.0f));
}
