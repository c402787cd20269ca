#include "grading/oracle/random_scene.h"
#include "worker/measure_pixel.h"
#include "world.h"
#include <catch2/catch.hpp>
#include <glm/gtx/component_wise.hpp>
#include <tbb/parallel_for.h>
#include <thread>

using namespace tests;
using debug::Quantity;
using grading::Random;

namespace {

constexpr glm::ivec2 size { 24, 16 };
constexpr double fieldOfView = 0.9;

// A scene before a camera at (0, 0, -3) that looks along z.
struct Seen {
    explicit Seen(Scene scene, const Features& features)
        : world(std::move(scene), features)
        , view { Trackball { static_cast<float>(fieldOfView), 3.0f, 1.5f }, features, {}, size }
    {
        view.camera.setCamera({ 0, 0, 0 }, { 0, 0, 0 }, 3.0f);
    }

    glm::vec3 measure(Quantity quantity, glm::ivec2 pixel)
    {
        view.quantity = quantity;
        return worker::measurePixel(world.scene, counting, view, pixel);
    }

    World world;
    accel::CountingBVH counting { world.bvh };
    worker::View view;
};

// All pixels, each in turn.
template <typename Do> void forEachPixel(const Do& what)
{
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            what(glm::ivec2(x, y));
}

struct Line {
    glm::dvec3 origin, direction;
};

// Through the middle of a pixel, from the camera's definition.
Line lineThrough(const Trackball& camera, glm::ivec2 pixel)
{
    const glm::dvec2 ndc = (glm::dvec2(pixel) + 0.5) / glm::dvec2(size) * 2.0 - 1.0;
    const glm::dvec2 onScreen = ndc * std::tan(fieldOfView / 2.0) * glm::dvec2(1.5, 1.0);
    return { camera.position(),
        glm::normalize(glm::dvec3(camera.forward()) - onScreen.x * glm::dvec3(camera.left())
            + onScreen.y * glm::dvec3(camera.up())) };
}

// (u, v, t) of origin + t direction = v0 + u (v1 - v0) + v (v2 - v0), by Cramer's rule.
glm::dvec3 solve(const Line& line, const glm::dvec3& v0, const glm::dvec3& v1, const glm::dvec3& v2)
{
    const glm::dvec3 e1 = v1 - v0, e2 = v2 - v0, s = line.origin - v0;
    const double whole = glm::determinant(glm::dmat3(e1, e2, -line.direction));
    return { glm::determinant(glm::dmat3(s, e2, -line.direction)) / whole,
        glm::determinant(glm::dmat3(e1, s, -line.direction)) / whole, glm::determinant(glm::dmat3(e1, e2, s)) / whole };
}

// How many boxes of the tree a line's first part meets, each side moved out by so much.
uint64_t countBoxes(const BVHInterface& bvh, const Line& line, double end, double out)
{
    const auto meets = [&](const AxisAlignedBox& box) {
        const glm::dvec3 a = (glm::dvec3(box.lower) - out - line.origin) / line.direction;
        const glm::dvec3 b = (glm::dvec3(box.upper) + out - line.origin) / line.direction;
        const double entry = std::max(glm::compMax(glm::min(a, b)), 0.0);
        return entry <= std::min(glm::compMin(glm::max(a, b)), end);
    };
    return static_cast<uint64_t>(std::ranges::count_if(std::as_const(bvh).nodes(), meets, &BVHInterface::Node::aabb));
}

Scene randomTriangles(int count)
{
    Scene scene;
    Random random(7);
    grading::addTriangles(scene, random, count);
    return scene;
}

}

TEST_CASE("Barycentric coordinates, texture coordinates, normal and t are those of the triangle", "[measure]")
{
    const std::array<Vertex, 3> corners { { { { -2.0f, -1.3f, 0.4f }, { 0, 0, -1 }, { 0.1f, 0.2f } },
        { { 1.7f, -1.0f, -0.3f }, { 0, 0, -1 }, { 0.9f, 0.3f } },
        { { 0.1f, 1.4f, 0.2f }, { 0, 0, -1 }, { 0.4f, 0.8f } } } };
    Scene scene;
    scene.meshes.emplace_back();
    grading::addTriangle(scene.meshes.back(), corners);
    Seen seen { std::move(scene), { .enableAccelStructure = GENERATE(false, true) } };
    const glm::dvec3 v0 { corners[0].position }, v1 { corners[1].position }, v2 { corners[2].position };
    glm::dvec3 normal = glm::normalize(glm::cross(v1 - v0, v2 - v0));
    normal *= normal.z > 0.0 ? -1.0 : 1.0; // towards the camera
    constexpr double rounding = 1e-5; // a dozen roundings of numbers of about 3
    int numMet = 0, numMissed = 0;
    forEachPixel([&](glm::ivec2 pixel) {
        const glm::dvec3 solved = solve(lineThrough(seen.view.camera, pixel), v0, v1, v2);
        const glm::dvec3 barycentric { 1.0 - solved.x - solved.y, solved.x, solved.y };
        REQUIRE(std::abs(glm::compMin(barycentric)) > rounding); // on no edge
        if (glm::compMin(barycentric) < 0.0) {
            ++numMissed;
            for (const Quantity q : { Quantity::Barycentric, Quantity::TexCoord, Quantity::Normal, Quantity::Distance })
                CHECK(seen.measure(q, pixel) == debug::nothing);
            return;
        }
        ++numMet;
        glm::dvec2 texCoord { 0.0 };
        for (int i = 0; i < 3; ++i)
            texCoord += barycentric[i] * glm::dvec2(corners[static_cast<std::size_t>(i)].texCoord);
        CHECK(distance(seen.measure(Quantity::Barycentric, pixel), barycentric) < rounding);
        CHECK(distance(seen.measure(Quantity::TexCoord, pixel), { texCoord, 0.0 }) < rounding);
        CHECK(distance(seen.measure(Quantity::Normal, pixel), normal) < rounding);
        CHECK(distance(seen.measure(Quantity::Distance, pixel), { solved.z, 0.0, 0.0 }) < rounding);
    });
    CHECK(numMet > 50);
    CHECK(numMissed > 50);
}

TEST_CASE("In a tree of one leaf every triangle is tested once, and none by a ray beside it", "[measure]")
{
    Scene scene;
    for (int i = 0; i < 2; ++i) // in one place: there is nothing to be had by splitting them
        addParallelogram(scene, {}, { -0.5f, -0.5f, -0.1f }, { 1, 0, 0 }, { 0, 1, 0.2f });
    Seen seen { std::move(scene), { .enableAccelStructure = GENERATE(false, true) } };
    REQUIRE(std::as_const(seen.world.bvh).nodes().size() == 1);
    CHECK(seen.measure(Quantity::TrianglesTested, size / 2) == glm::vec3(4, 0, 0));
    CHECK(seen.measure(Quantity::NodesVisited, size / 2) == glm::vec3(1, 0, 0));
    CHECK(seen.measure(Quantity::TrianglesTested, { 0, 0 }) == glm::vec3(0.0f));
    CHECK(seen.measure(Quantity::NodesVisited, { 0, 0 }) == glm::vec3(0.0f));
}

// Beside the surfaces, all boxes that the ray meets are visited; before one, no fewer than lie before it.
TEST_CASE("The nodes visited are those whose boxes the ray meets", "[measure]")
{
    Seen seen { randomTriangles(60), { .enableAccelStructure = GENERATE(false, true) } };
    constexpr double rounding = 1e-5; // of a box's distance
    const BVHInterface& bvh = seen.world.bvh;
    uint64_t most = 0;
    int numBeside = 0;
    forEachPixel([&](glm::ivec2 pixel) {
        const Line line = lineThrough(seen.view.camera, pixel);
        const double t = static_cast<double>(seen.measure(Quantity::Distance, pixel).x); // infinite where nothing is
        const auto visited = static_cast<uint64_t>(seen.measure(Quantity::NodesVisited, pixel).x);
        CHECK(visited >= countBoxes(bvh, line, t - rounding, -rounding));
        CHECK(visited <= countBoxes(bvh, line, std::numeric_limits<double>::infinity(), rounding));
        most = std::max(most, visited);
        numBeside += std::isinf(t) && visited > 0;
    });
    CHECK(most > 10);
    CHECK(numBeside > 10);
}

TEST_CASE("The reference and the library's own traversal test as many triangles and visit as many nodes", "[measure]")
{
    Seen ours { randomTriangles(60), { .enableAccelStructure = false } };
    Seen theirs { randomTriangles(60), { .enableAccelStructure = true } };
    const auto sumOf = [](Seen& seen, Quantity quantity) {
        float sum = 0.0f;
        forEachPixel([&](glm::ivec2 pixel) { sum += seen.measure(quantity, pixel).x; });
        return sum;
    };
    for (const Quantity quantity : { Quantity::NodesVisited, Quantity::TrianglesTested })
        CHECK(sumOf(ours, quantity) == Approx(sumOf(theirs, quantity)).epsilon(0.01)); // where a ray grazes a box
}

TEST_CASE("A pixel's samples and rays are counted", "[measure]")
{
    Scene scene;
    addParallelogram(scene, { .kd = glm::vec3(0.5f) }, { -1.0f, -0.2f, 0.0f }, { 2, 0, 0 }, { 0, 0.4f, 0 });
    scene.lights = { PointLight { { 0, 0, -2 }, glm::vec3(1.0f) } };
    const bool hasShadows = GENERATE(false, true);
    const float raysOfSample = hasShadows ? 2.0f : 1.0f; // the camera's, and one to the light
    Seen seen { std::move(scene),
        { .enableShading = true, .enableShadows = hasShadows, .enableAccelStructure = true } };
    CHECK(seen.measure(Quantity::Samples, size / 2) == glm::vec3(1, 0, 0));
    CHECK(seen.measure(Quantity::Rays, size / 2) == glm::vec3(raysOfSample, 0, 0));
    CHECK(seen.measure(Quantity::Rays, { 0, 0 }) == glm::vec3(1, 0, 0)); // nothing there
    seen.view.features.numPixelSamples = 25;
    seen.view.features.enableJitteredSampling = GENERATE(false, true);
    CHECK(seen.measure(Quantity::Samples, { 3, 2 }) == glm::vec3(25, 0, 0));
    CHECK(seen.measure(Quantity::Rays, size / 2) == glm::vec3(25 * raysOfSample, 0, 0));
    CHECK(seen.measure(Quantity::Rays, { 0, 0 }) == glm::vec3(25, 0, 0));
}

TEST_CASE("A pixel's rays are not those that another thread sends meanwhile", "[measure]")
{
    struct Disturbed : BVH {
        using BVH::BVH;
        bool intersect(RenderState& state, Ray& ray, HitInfo& hitInfo) const override
        {
            std::thread([] {
                World elsewhere;
                Ray other;
                HitInfo nothing {};
                (void)accel::CountingBVH(elsewhere.bvh).intersect(elsewhere.state, other, nothing);
            }).join();
            return BVH::intersect(state, ray, hitInfo);
        }
    };
    const Seen seen { randomTriangles(4), {} };
    Disturbed bvh { seen.world.scene, {} };
    const accel::CountingBVH counting { bvh };
    worker::View view = seen.view;
    view.quantity = Quantity::Rays;
    CHECK(worker::measurePixel(seen.world.scene, counting, view, size / 2) == glm::vec3(1, 0, 0));
}

TEST_CASE("Pixels that are measured at once have the values of pixels measured in turn", "[measure]")
{
    Scene scene = randomTriangles(60);
    scene.lights = { PointLight { { 0, 2, -2 }, glm::vec3(1.0f) } };
    const Features features { .enableShading = true, .enableShadows = true, .enableAccelStructure = true };
    Seen seen { std::move(scene), features };
    for (const Quantity quantity : debug::allQuantities()) {
        INFO(debug::nameOf(quantity));
        seen.view.quantity = quantity;
        std::vector<glm::vec3> inTurn, atOnce(static_cast<std::size_t>(size.x * size.y));
        forEachPixel([&](glm::ivec2 pixel) { inTurn.push_back(seen.measure(quantity, pixel)); });
        tbb::parallel_for(0, size.x * size.y, [&](int i) {
            atOnce[static_cast<std::size_t>(i)]
                = worker::measurePixel(seen.world.scene, seen.counting, seen.view, { i % size.x, i / size.x });
        });
        CHECK(atOnce == inTurn);
    }
}
