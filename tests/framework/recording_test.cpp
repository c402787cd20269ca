#include "debug/recording.h"
#include "draw.h"
#include "light.h"
#include "recursive.h"
#include "world.h"
#include <catch2/catch.hpp>
#include <thread>

using namespace tests;
using debug::Recording;

namespace {

const glm::vec3 red { 1, 0, 0 };
const Ray ray { { 1, 2, 3 }, { 0, 0, -1 }, 2.0f };

// Mirrors, glass, textures aside: whatever sends rays or draws random numbers.
Scene busyScene()
{
    Scene scene;
    addPane(scene, { .kd = glm::vec3(0.5f), .ks = glm::vec3(0.5f), .transparency = 0.5f }, -2.0f);
    addPane(scene, { .kd = glm::vec3(0.7f) }, -3.0f);
    addPane(scene, { .kd = glm::vec3(0.2f), .ks = glm::vec3(0.3f) }, 2.0f);
    scene.lights = { PointLight { { 1, 1, 1 }, glm::vec3(1.0f) },
        ParallelogramLight { { -1, -1, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, red, glm::vec3(1.0f), red, red } };
    return scene;
}

constexpr Features all { .enableShading = true,
    .enableReflections = true,
    .enableShadows = true,
    .enableAccelStructure = true,
    .enableTransparency = true,
    .enableDebugDraw = true };

std::vector<glm::vec3> renderSome(World& world)
{
    world.state.sampler = Sampler(1);
    std::vector<glm::vec3> colors;
    for (int i = 0; i < 50; ++i)
        colors.push_back(
            renderRay(world.state, { glm::vec3(0.02f * static_cast<float>(i), 0.1f, 0.0f), { 0.1f, 0, -1 } }));
    return colors;
}

}

TEST_CASE("A recording holds what was drawn, in order, as values", "[recording]")
{
    const Vertex vertex { { 1, 2, 3 }, { 0, 0, 1 }, { 0.5f, 0.25f } };
    const Recording recording;
    drawRay(ray, red);
    drawAABB({ glm::vec3(1.0f), glm::vec3(2.0f) }, DrawMode::Wireframe, red, 0.5f);
    drawTriangle(vertex, vertex, vertex);
    drawSphere({ 1, 2, 3 }, 4.0f, red);
    REQUIRE(recording.shapes().size() == 4);
    const auto& drawnRay = std::get<debug::DrawnRay>(recording.shapes()[0].drawn);
    CHECK(drawnRay.ray.origin == ray.origin);
    CHECK(drawnRay.ray.direction == ray.direction);
    CHECK(drawnRay.ray.t == ray.t);
    CHECK(drawnRay.color == red);
    const auto& box = std::get<debug::DrawnBox>(recording.shapes()[1].drawn);
    CHECK(box.box.upper == glm::vec3(2.0f));
    CHECK(box.mode == DrawMode::Wireframe);
    CHECK(box.color == red);
    CHECK(box.transparency == 0.5f);
    CHECK(std::get<debug::DrawnTriangle>(recording.shapes()[2].drawn).v1 == vertex);
    const auto& sphere = std::get<debug::DrawnSphere>(recording.shapes()[3].drawn);
    CHECK(sphere.center == glm::vec3(1, 2, 3));
    CHECK(sphere.radius == 4.0f);
    CHECK(sphere.color == red);
}

TEST_CASE("Drawing a scene draws each of its triangles and spheres", "[recording]")
{
    Scene scene = busyScene();
    scene.spheres.resize(2);
    const Recording recording;
    drawScene(scene);
    const auto count = [&]<typename Drawn>() {
        return std::ranges::count_if(
            recording.shapes(), [](const debug::Shape& shape) { return std::holds_alternative<Drawn>(shape.drawn); });
    };
    CHECK(count.operator()<debug::DrawnTriangle>() == 6);
    CHECK(count.operator()<debug::DrawnSphere>() == 2);
}

TEST_CASE("Of nested recordings the innermost hears what is drawn", "[recording]")
{
    CHECK_FALSE(Recording::isOpen());
    {
        const Recording outer;
        drawRay(ray);
        {
            const Recording inner;
            drawRay(ray);
            drawRay(ray);
            CHECK(inner.shapes().size() == 2);
        }
        CHECK(Recording::isOpen());
        drawRay(ray);
        CHECK(outer.shapes().size() == 2);
    }
    CHECK_FALSE(Recording::isOpen());
    drawRay(ray); // nobody listens
    const Recording later;
    CHECK(later.shapes().empty());
}

TEST_CASE("A recording keeps the first shapes that it has room for and counts the rest", "[recording]")
{
    const Recording recording(3);
    for (int i = 0; i < 10; ++i)
        drawSphere({}, static_cast<float>(i));
    REQUIRE(recording.shapes().size() == 3);
    CHECK(recording.numDropped() == 7);
    CHECK(std::get<debug::DrawnSphere>(recording.shapes()[2].drawn).radius == 2.0f);
}

TEST_CASE("A recording does not hear other threads", "[recording]")
{
    const Recording recording;
    bool openElsewhere = true;
    std::thread([&] {
        openElsewhere = Recording::isOpen();
        drawRay(ray);
        const Recording theirs;
        drawRay(ray);
    }).join();
    CHECK_FALSE(openElsewhere);
    CHECK(recording.shapes().empty());
}

TEST_CASE("Recording changes no colour, bit for bit", "[recording]")
{
    World world(busyScene(), all);
    const auto unheard = renderSome(world);
    const Recording recording;
    CHECK(renderSome(world) == unheard);
    CHECK(recording.shapes().size() > 100);
    world.features.enableDebugDraw = false;
    CHECK(renderSome(world) == unheard);
}

TEST_CASE("The rays to lights are red, mirrored ones green, normals yellow", "[recording]")
{
    World world(busyScene(), all);
    const Recording recording;
    (void)renderRay(world.state, { {}, { 0.1f, 0, -1 } });
    const auto count = [&](const glm::vec3& color) {
        return std::ranges::count_if(recording.shapes(), [&](const debug::Shape& shape) {
            const auto* drawn = std::get_if<debug::DrawnRay>(&shape.drawn);
            return drawn && drawn->color == color && shape.cause.way == debug::Way::Path;
        });
    };
    CHECK(count(red) > 0);
    CHECK(count({ 0, 1, 0 }) > 0);
    CHECK(count({ 1, 1, 0 }) == count({ 0, 1, 0 }));
}

TEST_CASE("A tree's levels and leaves can be drawn, each of them once", "[recording]")
{
    World world(busyScene());
    std::size_t boxes = 0, triangles = 0;
    const auto drawn = [&](const Recording& recording) {
        for (const debug::Shape& shape : recording.shapes())
            (std::holds_alternative<debug::DrawnBox>(shape.drawn) ? boxes : triangles) += 1;
    };
    for (uint32_t level = 0; level < world.bvh.numLevels(); ++level) {
        const Recording recording;
        world.bvh.debugDrawLevel(static_cast<int>(level));
        drawn(recording);
    }
    CHECK(boxes == world.bvh.nodes().size());
    boxes = 0;
    for (uint32_t leaf = 1; leaf <= world.bvh.numLeaves(); ++leaf) {
        const Recording recording;
        world.bvh.debugDrawLeaf(static_cast<int>(leaf));
        drawn(recording);
    }
    CHECK(boxes == world.bvh.numLeaves());
    CHECK(triangles == world.bvh.primitives().size());
}

TEST_CASE("What was drawn tells its bounce, and whether it was a ray to a light", "[recording]")
{
    World world(busyScene(), all);
    world.features.enableDebugDraw = false;
    const Recording recording;
    (void)renderRay(world.state, { {}, { 0.1f, 0, -1 } });
    int16_t deepest = 0;
    for (const debug::Shape& shape : recording.shapes()) {
        const auto* drawn = std::get_if<debug::DrawnRay>(&shape.drawn);
        deepest = std::max(deepest, shape.cause.bounce);
        if (drawn && drawn->color == glm::vec3(1.0f)) // of renderRay itself
            CHECK(shape.cause.way == debug::Way::Path);
        if (std::holds_alternative<debug::DrawnSphere>(shape.drawn))
            CHECK((shape.cause.way == debug::Way::Shadow
                || std::get<debug::DrawnSphere>(shape.drawn).radius == 0.01f)); // the samples; passthrough's are small
    }
    CHECK(deepest == 6);
    REQUIRE_FALSE(recording.hits().empty());
    CHECK(recording.hits().front().cause.bounce == 0);
    CHECK(recording.hits().front().ray.t == 2.0f);
    CHECK(recording.hits().front().hitInfo.normal == glm::vec3(0, 0, 1));
    CHECK(recording.shapes().front().cause == debug::Cause { 0, debug::Way::Path });
    CHECK(recording.shapes().back().cause.bounce == 0); // what is drawn after a bounce is its parent's again
}
