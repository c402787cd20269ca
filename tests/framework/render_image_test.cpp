#include "accel/counting_bvh.h"
#include "app/render_pixels.h"
#include "files/scene_file.h"
#include "screen.h"
#include "world.h"
#include <catch2/catch.hpp>
#include <tbb/global_control.h>
#include <thread>
#include <type_traits>

using namespace tests;

// A hit is copied once a surface: no reference is counted.
static_assert(std::is_trivially_copyable_v<HitInfo>);
static_assert(std::is_trivially_copyable_v<Material>);
static_assert(std::is_trivially_copyable_v<Ray>);

namespace {

constexpr int width = 48, height = 36;

files::SceneFile cornellBox()
{
    files::SceneFile file = files::loadSceneFile(RAYWORK_SCENES "/cornell_box_parallelogram_light.toml");
    file.config.size = { width, height };
    file.config.features.enableShadows = true;
    file.config.features.numPixelSamples = 4;
    file.config.features.numShadowSamples = 2;
    return file;
}

std::vector<glm::vec3> render(const files::SceneFile& file, std::size_t numThreads, uint32_t seed = 0)
{
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, numThreads);
    const World world(file.scene, file.config.features);
    Screen screen(file.config.size);
    app::renderPixels(world.scene, world.bvh, world.features, makeTrackball(file.config), screen, seed);
    return screen.pixels();
}

}

TEST_CASE("A picture is the same bit for bit with one thread and with many", "[render_image]")
{
    const files::SceneFile file = cornellBox();
    const auto picture = render(file, 1);
    CHECK(picture == render(file, 4));
    CHECK(picture == render(file, 4));
    CHECK(picture != render(file, 1, 1)); // its random numbers follow from the seed
    for (const glm::vec3& pixel : picture)
        CHECK((isFinite(pixel) && glm::all(glm::greaterThanEqual(pixel, glm::vec3(0.0f)))));
}

TEST_CASE("renderImage fills the screen as renderPixels does", "[render_image]")
{
    const files::SceneFile file = cornellBox();
    const World world(file.scene, file.config.features);
    Screen screen(file.config.size);
    renderImage(world.scene, world.bvh, world.features, makeTrackball(file.config), screen);
    CHECK(screen.pixels() == render(file, 1));
    CHECK(screen.rowsStarted() == height);
}

TEST_CASE("Extensions that nobody wrote leave the picture as it is", "[render_image]")
{
    files::SceneFile file = cornellBox();
    file.config.features.extra.enableBloomEffect = true;
    file.config.features.extra.enableEnvironmentMap = true;
    CHECK(render(file, 1) == render(cornellBox(), 1));
    const auto pictureWith = [&](bool ExtraFeatures::*feature) {
        files::SceneFile other = cornellBox();
        other.config.features.extra.*feature = true;
        const World world(other.scene, other.config.features);
        Screen screen(other.config.size);
        renderImage(world.scene, world.bvh, world.features, makeTrackball(other.config), screen);
        return screen.pixels();
    };
    for (const auto feature : { &ExtraFeatures::enableDepthOfField, &ExtraFeatures::enableMotionBlur,
             &ExtraFeatures::enableBloomEffect, &ExtraFeatures::enableGlossyReflection })
        CHECK(pictureWith(feature) == render(cornellBox(), 1));
}

TEST_CASE("The counting tree counts the rays of all threads and changes no pixel", "[render_image]")
{
    files::SceneFile file = cornellBox();
    file.config.features.enableShadows = false;
    file.config.features.enableReflections = false;
    World world(file.scene, file.config.features);
    const accel::CountingBVH counting(world.bvh);
    for (const std::size_t numThreads : { 1u, 4u }) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, numThreads);
        Screen screen(file.config.size);
        const accel::RayCounts before = accel::CountingBVH::rayCounts();
        renderImage(world.scene, counting, world.features, makeTrackball(file.config), screen);
        CHECK((accel::CountingBVH::rayCounts() - before).total() == 4u * width * height); // camera rays alone
        CHECK(screen.pixels() == render(file, 1));
    }
    CHECK(counting.numLevels() == world.bvh.numLevels());
    CHECK(counting.nodes().data() == world.bvh.nodes().data());
    CHECK(counting.primitives().data() == world.bvh.primitives().data());
}

TEST_CASE("The rays of a thread that has ended still count", "[render_image]")
{
    World world;
    const accel::CountingBVH counting(world.bvh);
    const accel::RayCounts before = accel::CountingBVH::rayCounts();
    const auto trace = [&] {
        Ray ray;
        HitInfo hit;
        (void)counting.intersect(world.state, ray, hit);
    };
    for (int i = 0; i < 5; ++i)
        std::thread(trace).join();
    trace();
    CHECK((accel::CountingBVH::rayCounts() - before).total() == 6);
}
