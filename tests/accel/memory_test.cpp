#include "accel/wide/tree.h"
#include "bvh.h"
#include <catch2/catch.hpp>
#include <sys/resource.h>
#include <tbb/global_control.h>

namespace {

// Bytes that this process has held at once.
std::size_t mostMemory()
{
    rusage usage {};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

// So many squares to a side, each of two triangles, in waves.
Scene sheet(uint32_t side)
{
    Scene scene;
    Mesh& mesh = scene.meshes.emplace_back();
    mesh.vertices.reserve((side + 1) * (side + 1));
    mesh.triangles.reserve(2 * side * side);
    for (uint32_t y = 0; y <= side; ++y)
        for (uint32_t x = 0; x <= side; ++x) {
            const glm::vec2 at = glm::vec2(x, y) / static_cast<float>(side);
            mesh.vertices.push_back({ { at.x, 0.1f * std::sin(9.0f * at.x) * std::cos(7.0f * at.y), at.y }, {}, at });
        }
    for (uint32_t y = 0; y < side; ++y)
        for (uint32_t x = 0; x < side; ++x) {
            const uint32_t corner = y * (side + 1) + x, above = corner + side + 1;
            mesh.triangles.emplace_back(corner, corner + 1, above);
            mesh.triangles.emplace_back(corner + 1, above + 1, above);
        }
    return scene;
}

}

TEST_CASE(
    "A large mesh takes at most 200 bytes a triangle at any time, while the library's own tree is built, too", "[wide]")
{
    const tbb::global_control two(tbb::global_control::max_allowed_parallelism, 2); // each has some memory to work in
    const std::size_t before = mostMemory();
    const Scene scene = sheet(1000);
    const BVH bvh(scene, {});
    REQUIRE(bvh.numPrimitives() == 2 * 1000 * 1000);
    CHECK(bvh.wideTree()->closest({ { 0.51f, 1.0f, 0.52f }, { 0.0f, -1.0f, 0.0f } }));
    CHECK((mostMemory() - before) / bvh.numPrimitives() <= 200);
}
