#include "files/scene_file.h"
#include "recursive.h"
#include "screen.h"
#include "world.h"
#include <atomic>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <new>

namespace {

std::atomic<int> numAllocations = 0;

}

void* operator new(std::size_t size)
{
    ++numAllocations;
    if (void* memory = std::malloc(size))
        return memory;
    throw std::bad_alloc();
}

void operator delete(void* memory) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}

using namespace tests;

namespace {

files::SceneFile busyScene()
{
    files::SceneFile file = files::loadSceneFile(RAYWORK_SCENES "/cornell_box_parallelogram_light.toml");
    Features& features = file.config.features;
    features.enableShading = features.enableShadows = features.enableReflections = features.enableTransparency = true;
    features.enableTextureMapping = features.enableNormalInterp = true;
    file.scene.meshes.back().material.transparency = 0.5f;
    file.config.size = { 64, 64 };
    return file;
}

template <typename F> int allocationsOf(const F& f)
{
    const int before = numAllocations;
    f();
    return numAllocations - before;
}

}

TEST_CASE("Allocations are counted", "[allocations]")
{
    static int* volatile memory; // volatile: an unused allocation may be left out
    CHECK(allocationsOf([] { memory = new int; }) == 1);
    delete memory;
}

TEST_CASE("Tracing a ray to its end allocates nothing", "[allocations]")
{
    const bool accel = GENERATE(true, false);
    const files::SceneFile file = busyScene();
    World world(file.scene, file.config.features);
    world.features.enableAccelStructure = accel;
    const Trackball camera = makeTrackball(file.config);
    (void)renderRay(world.state, camera.generateRay({ 0.0f, 0.0f })); // builds the library's tree
    const int count = allocationsOf([&] {
        for (float y = -0.95f; y < 1.0f; y += 0.1f)
            for (float x = -0.95f; x < 1.0f; x += 0.1f)
                (void)renderRay(world.state, camera.generateRay({ x, y }));
    });
    CHECK(count == 0);
}

TEST_CASE("A picture allocates one vector a pixel, which is the interface's, and little else", "[allocations]")
{
    constexpr int tasks = 1000; // more than threads and their tasks want, less than a pixel each
    const files::SceneFile file = busyScene();
    const World world(file.scene, file.config.features);
    const Trackball camera = makeTrackball(file.config);
    Screen screen(file.config.size);
    const auto render = [&] { renderImage(world.scene, world.bvh, world.features, camera, screen); };
    render(); // starts the threads
    CHECK(allocationsOf(render) <= 64 * 64 + tasks);
}
