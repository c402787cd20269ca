#include "bvh.h"
#include "files/scene_file.h"
#include "files/temporary_folder.h"
#include "recursive.h"
#include "screen.h"
#include "world.h"
#include <atomic>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fmt/format.h>
#include <malloc.h>
#include <new>

namespace {

std::atomic<int> numAllocations = 0;
std::atomic<std::size_t> numBytes = 0, mostBytes = 0; // in use

void noteMost(std::size_t bytes)
{
    std::size_t most = mostBytes;
    while (bytes > most && !mostBytes.compare_exchange_weak(most, bytes)) { }
}

}

void* operator new(std::size_t size)
{
    ++numAllocations;
    void* const memory = std::malloc(size);
    if (!memory)
        throw std::bad_alloc();
    noteMost(numBytes += malloc_usable_size(memory));
    return memory;
}

void operator delete(void* memory) noexcept
{
    numBytes -= malloc_usable_size(memory);
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
    operator delete(memory);
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
    const std::size_t before = numBytes;
    CHECK(allocationsOf([] { memory = new int; }) == 1);
    CHECK(numBytes >= before + sizeof(int));
    CHECK(mostBytes >= numBytes);
    delete memory;
    CHECK(numBytes == before);
}

TEST_CASE("A large mesh takes at most 200 bytes a triangle at any time, while it is read and its tree is built",
    "[allocations]")
{
    constexpr int n = 400;
    std::string text;
    for (int i = 0; i < n * n; ++i)
        text += fmt::format("v {} {} {}\n", i % n, i / n, i * 7 % 11);
    for (int i = n; i < n * n; ++i)
        if (i % n > 0) // counted from 1, as corners are: the upper left one of a square
            text += fmt::format("f {0} {1} {2}\nf {1} {3} {2}\n", i - n, i - n + 1, i, i + 1);
    const files_test::TemporaryFolder folder;
    const std::filesystem::path path = folder.write("sheet.obj", text);
    text = std::string();

    const std::size_t before = numBytes;
    mostBytes = before;
    const files::SceneFile file = files::loadSceneFile(path);
    const BVH bvh(file.scene, file.config.features);
    const std::size_t numTriangles = std::as_const(bvh).primitives().size();
    REQUIRE(numTriangles == 2 * (n - 1) * (n - 1));
    CHECK((mostBytes - before) / numTriangles <= 200);
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
