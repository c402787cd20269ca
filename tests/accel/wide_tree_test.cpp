#include "accel/wide/tree.h"
#include "bench/closed_mesh.h"
#include "bench/exact_hits.h"
#include "random_triangles.h"
#include <algorithm>
#include <catch2/catch.hpp>

using accel::WideTree;
using bench::ClosedMesh;
using grading::Random;
using tests::randomTriangles;
using Triangle = WideTree::Triangle;

namespace {

Ray randomRay(Random& random)
{
    const glm::vec3 origin = random.vec3(-2.0f, 2.0f);
    return { origin, random.vec3(-1.0f, 1.0f) - origin };
}

// All kernels against the oracle, and against each other.
void checkRay(const WideTree& tree, const std::vector<Triangle>& triangles, const Ray& ray)
{
    const bench::ExactHits exact(triangles, ray);
    const auto first = tree.closest(ray);
    for (const accel::wide::Kernel* kernel : accel::wide::kernels()) {
        CAPTURE(kernel->name);
        const auto hit = tree.closest(ray, *kernel);
        CHECK(exact.judge(hit) != bench::Verdict::Wrong);
        CHECK(tree.occluded(ray, *kernel) == hit.has_value());
        REQUIRE(hit.has_value() == first.has_value());
        if (hit)
            CHECK(
                (hit->t == first->t && hit->primitive == first->primitive && hit->u == first->u && hit->v == first->v));
    }
}

}

TEST_CASE("Wide tree, finds what a double-precision search of all triangles finds", "[wide]")
{
    Random random(1, "wide");
    for (const int count : { 1, 2, 8, 9, 40, 300, 3000 }) {
        for (const float size : { 0.02f, 0.3f, 2.0f }) {
            CAPTURE(count, size);
            const auto triangles = randomTriangles(random, count, size);
            const WideTree tree(triangles);
            for (int i = 0; i < 200; ++i)
                checkRay(tree, triangles, randomRay(random));
        }
    }
}

TEST_CASE(
    "Wide tree, triangles in a ray's plane, but for their roundings, are met only if they are in its way", "[wide]")
{
    Random random(1, "edge-on");
    for (int i = 0; i < 100000; ++i) {
        const Ray ray { random.vec3(-1.0f, 1.0f), random.vec3(-1.0f, 1.0f) };
        const glm::vec3 across = random.vec3(-1.0f, 1.0f);
        const auto corner = [&] {
            return ray.origin + (3.0f * random.uniform() + 0.1f) * ray.direction
                + (0.5f * random.uniform() - 0.1f) * across;
        };
        const std::vector<Triangle> triangles { { corner(), corner(), corner() } };
        const WideTree tree(triangles);
        const bench::ExactHits exact(triangles, ray);
        for (const accel::wide::Kernel* kernel : accel::wide::kernels())
            REQUIRE(exact.judge(tree.occluded(ray, *kernel)) != bench::Verdict::Wrong);
    }
}

TEST_CASE("Wide tree, rays along axes and in the planes of faces find what lies there", "[wide]")
{
    std::vector<Triangle> triangles; // three walls of a grid, on round coordinates
    for (int i = 0; i < 20; ++i) {
        for (int j = 0; j < 20; ++j) {
            for (int axis = 0; axis < 3; ++axis) {
                const auto at = [&](int u, int v) {
                    glm::vec3 p(0.0f);
                    p[(axis + 1) % 3] = static_cast<float>(u);
                    p[(axis + 2) % 3] = static_cast<float>(v);
                    return p;
                };
                triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
                triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
            }
        }
    }
    const WideTree tree(triangles);
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i <= 40; ++i) {
            for (int j = 0; j <= 40; ++j) { // corners and edges of the grid among them
                Ray ray { glm::vec3(5.0f), glm::vec3(0.0f) };
                ray.origin[(axis + 1) % 3] = 0.5f * static_cast<float>(i);
                ray.origin[(axis + 2) % 3] = 0.5f * static_cast<float>(j);
                for (const float zero : { 0.0f, -0.0f }) {
                    ray.direction = glm::vec3(zero);
                    ray.direction[axis] = -1.0f;
                    for (const accel::wide::Kernel* kernel : accel::wide::kernels()) {
                        const auto hit = tree.closest(ray, *kernel);
                        REQUIRE(hit);
                        CHECK(hit->t == 5.0f);
                        CHECK(tree.occluded(ray, *kernel));
                    }
                }
            }
        }
    }
}

TEST_CASE("Wide tree, of triangles that coincide the first is found, and those without area never", "[wide]")
{
    const glm::vec3 a { 0, 0, 0 }, b { 1, 0, 0 }, c { 0, 1, 0 };
    const Ray ray { { 0.25f, 0.25f, 1.0f }, { 0, 0, -1 } };
    for (const std::size_t count : { 1u, 7u, 8u, 9u, 64u, 65u, 5000u }) {
        CAPTURE(count);
        CHECK(WideTree(std::vector<Triangle>(count, { a, b, c })).closest(ray).value().primitive == 0);
        CHECK_FALSE(WideTree(std::vector<Triangle>(count, { a, a, a }))
                        .closest({ a + glm::vec3(0, 0, 1), -glm::vec3(0, 0, 1) }));
        CHECK_FALSE(WideTree(std::vector<Triangle>(count, { a, b, b })).closest(ray));
    }
}

TEST_CASE("Wide tree, what is not a number is never met and hides nothing", "[wide]")
{
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    const glm::vec3 a { 0, 0, 0 }, b { 1, 0, 0 }, c { 0, 1, 0 };
    std::vector<Triangle> triangles(100, { a, b, glm::vec3(nan, 0, 0) });
    triangles.resize(200, { a, glm::vec3(infinity, 0, 0), c });
    triangles.push_back({ a, b, c });
    CHECK(WideTree(triangles).closest({ { 0.25f, 0.25f, 1.0f }, { 0, 0, -1 } }).value().primitive == 200);
}

TEST_CASE("Wide tree, huge and tiny coordinates are built and traced", "[wide]")
{
    for (const float scale : { 1e-12f, 1e-3f, 1e3f, 1e9f }) {
        CAPTURE(scale);
        ClosedMesh mesh(3);
        mesh.move(scale, glm::vec3(0.0f));
        CHECK(WideTree(mesh.triangles).closest({ glm::vec3(0.0f), { 0.3f, 0.4f, 0.5f } }));
    }
    ClosedMesh mesh(3);
    mesh.move(1e30f, glm::vec3(0.0f)); // areas overflow
    (void)WideTree(mesh.triangles);
}

TEST_CASE("Wide tree, without triangles nothing is met", "[wide]")
{
    const WideTree tree({});
    CHECK_FALSE(tree.closest({}));
    CHECK_FALSE(tree.occluded({}));
    CHECK(tree.numBytes() == 0);
}

TEST_CASE("Wide tree, the end of a ray belongs to it, and nothing behind it does", "[wide]")
{
    Random random(1, "limit");
    const auto triangles = randomTriangles(random, 500, 0.3f);
    const WideTree tree(triangles);
    for (int i = 0; i < 2000; ++i) {
        Ray ray = randomRay(random);
        const auto hit = tree.closest(ray);
        if (!hit)
            continue;
        for (const accel::wide::Kernel* kernel : accel::wide::kernels()) {
            ray.t = hit->t;
            CHECK(tree.closest(ray, *kernel).value().primitive == hit->primitive);
            CHECK(tree.occluded(ray, *kernel));
            ray.t = std::nextafter(hit->t, -1.0f);
            CHECK_FALSE(tree.closest(ray, *kernel));
            CHECK_FALSE(tree.occluded(ray, *kernel));
        }
    }
}

TEST_CASE("Wide tree, what is found does not depend on the order of the triangles", "[wide]")
{
    Random random(1, "order");
    auto triangles = randomTriangles(random, 1000, 0.3f);
    const WideTree tree(triangles);
    std::ranges::reverse(triangles);
    const WideTree reversed(triangles);
    for (int i = 0; i < 2000; ++i) {
        const Ray ray = randomRay(random);
        const auto hit = tree.closest(ray), other = reversed.closest(ray);
        REQUIRE(hit.has_value() == other.has_value());
        if (hit)
            CHECK((hit->t == other->t && hit->primitive == triangles.size() - 1 - other->primitive));
    }
}

TEST_CASE("Wide tree, no ray from inside leaves a closed mesh, through corners and edges neither", "[wide]")
{
    Random random(1, "watertight");
    for (const float scale : { 1e-3f, 1.0f, 1e3f }) {
        for (const float distance : { 0.0f, 1.0f, 1e3f, 1e6f }) {
            CAPTURE(scale, distance);
            ClosedMesh mesh(5);
            mesh.move(scale, distance * glm::vec3(0.3f, -0.5f, 0.8f));
            const WideTree tree(mesh.triangles);
            int numMisses = 0;
            for (int i = 0; i < 10'000; ++i) {
                const Triangle& triangle = mesh.triangles[static_cast<std::size_t>(random.uniform(0.0f, 8191.0f))];
                const float s = i % 2 == 0 ? 0.0f : random.uniform(0.0f, 1.0f);
                const glm::vec3 target = triangle[0] + s * (triangle[1] - triangle[0]);
                const glm::vec3 inside = 0.3f * random.vec3(-1.0f, 1.0f) + distance * glm::vec3(0.3f, -0.5f, 0.8f);
                const Ray ray { scale * inside, target - scale * inside };
                for (const accel::wide::Kernel* kernel : accel::wide::kernels())
                    numMisses += !tree.closest(ray, *kernel) + !tree.occluded(ray, *kernel);
            }
            CHECK(numMisses == 0);
        }
    }
}

TEST_CASE("Wide tree, counts the nodes and blocks that a ray is tested against, with the same answer", "[wide]")
{
    const ClosedMesh mesh(5);
    const WideTree tree(mesh.triangles);
    const Ray ray { glm::vec3(0.0f), { 0.3f, 0.4f, 0.5f } };
    accel::wide::Counters closest, any;
    CHECK(tree.closest(ray, closest).value().t == tree.closest(ray).value().t);
    CHECK(tree.occluded(ray, any));
    for (const accel::wide::Counters& counters : { closest, any }) {
        CHECK(counters.nodes >= 2); // sixteen blocks below one have 256 triangles, not 8192
        CHECK(counters.nodes < 20);
        CHECK(counters.blocks >= 1);
        CHECK(counters.blocks < 20);
    }
}

TEST_CASE("Wide tree, takes at most ninety bytes a triangle of a fine mesh", "[wide]")
{
    const ClosedMesh mesh(6);
    CHECK(WideTree(mesh.triangles).numBytes() <= 90 * mesh.triangles.size());
}
