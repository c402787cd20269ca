#include "accel/counting_bvh.h"
#include "accel/recording_bvh.h"
#include "bench/frame_comparison.h"
#include "files/scene_file.h"
#include "screen.h"
#include "worker/measure_speed.h"
#include "world.h"
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <tbb/global_control.h>

using namespace tests;

namespace {

// Light goes through one of its blocks, and the other mirrors.
files::SceneFile busyScene()
{
    files::SceneFile file = files::loadSceneFile(RAYWORK_SCENES "/cornell_box_transparency.toml");
    Features& features = file.config.features;
    features.enableShading = features.enableShadows = features.enableReflections = features.enableTransparency = true;
    file.scene.meshes.back().material.ks = glm::vec3(0.5f);
    file.config.size = { 24, 16 };
    return file;
}

accel::RecordedRays record(const files::SceneFile& file)
{
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    World world(file.scene, file.config.features);
    accel::RecordedRays recorded;
    Screen screen(file.config.size);
    renderImage(
        world.scene, accel::RecordingBVH(world.bvh, recorded), world.features, makeTrackball(file.config), screen);
    return recorded;
}

uint64_t countRays(const files::SceneFile& file)
{
    World world(file.scene, file.config.features);
    Screen screen(file.config.size);
    const accel::RayCounts before = accel::CountingBVH::rayCounts();
    renderImage(world.scene, accel::CountingBVH(world.bvh), world.features, makeTrackball(file.config), screen);
    return (accel::CountingBVH::rayCounts() - before).total();
}

std::vector<worker::Timing> timingsOf(const worker::Speed& speed)
{
    std::vector<worker::Timing> all { speed.frame, speed.hits, speed.traversal, speed.theirFrame, speed.theirHits };
    all.insert(all.end(), speed.threadedFrames.begin(), speed.threadedFrames.end());
    return all;
}

worker::Timing timing(uint64_t numRays, std::vector<double> seconds)
{
    return { .numRays = numRays, .seconds = std::move(seconds) };
}

worker::Speed speedOf(uint64_t numTriangles)
{
    worker::Speed speed { .numTriangles = numTriangles };
    speed.frame = timing(6'000'000, { 2.0, 1.0, 3.0 });
    speed.traversal = timing(6'000'000, { 0.5, 1.0, 0.6 });
    speed.hits = timing(6'000'000, { 1.0, 1.0, 1.0 });
    speed.theirFrame = timing(3'000'000, { 4.0, 5.0, 6.0 });
    speed.theirHits = timing(6'000'000, { 3.0, 3.0, 3.0 });
    speed.threadedFrames = { timing(6'000'000, { 0.5, 0.6, 0.7 }) };
    speed.threadedFrames.front().numThreads = 2;
    return speed;
}

}

TEST_CASE("Camera rays are recorded as they were before they met something", "[speed]")
{
    files::SceneFile file = busyScene();
    file.config.features = { .enableAccelStructure = true };
    const accel::RecordedRays recorded = record(file);
    const glm::ivec2 size = file.config.size;
    const Trackball camera = makeTrackball(file.config);
    REQUIRE(recorded.rays.size() == static_cast<std::size_t>(size.x * size.y));
    // In which order a thread takes the rows is its own affair.
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const Ray ray = camera.generateRay((glm::vec2(x, y) + 0.5f) / glm::vec2(size) * 2.0f - 1.0f);
            CHECK(std::ranges::count_if(recorded.rays, [&](const Ray& r) {
                return r.origin == ray.origin && r.direction == ray.direction && r.t == ray.t;
            }) == 1);
        }
    }
}

TEST_CASE("All rays are recorded, and those that met something are counted", "[speed]")
{
    const files::SceneFile file = busyScene();
    const accel::RecordedRays recorded = record(file);
    CHECK(recorded.numRays() == countRays(file));
    World world(file.scene, file.config.features);
    uint64_t numHits = 0;
    for (const std::vector<Ray>& rays : { recorded.rays, recorded.shadowRays }) {
        for (Ray ray : rays) {
            HitInfo hitInfo;
            numHits += world.bvh.intersect(world.state, ray, hitInfo);
        }
    }
    CHECK(recorded.numHits == numHits);
    CHECK(numHits > 24 * 16); // the camera looks into the box
    CHECK(numHits < recorded.numRays());
}

TEST_CASE("Everybody is measured with all rays of the frame, as often as asked", "[speed]")
{
    const files::SceneFile file = busyScene();
    const uint64_t numRays = countRays(file);
    const worker::Speed speed = worker::measureSpeed(file.scene, file.config, 3);
    CHECK(speed.numTriangles == 30);
    for (const worker::Timing& timing : timingsOf(speed)) {
        CHECK(timing.numRays == Approx(static_cast<double>(numRays)).epsilon(0.01)); // where one grazes an edge
        CHECK(timing.numHits == Approx(static_cast<double>(speed.frame.numHits)).epsilon(0.01));
        CHECK(timing.seconds.size() == 3);
    }
    CHECK(speed.traversal.numRays == speed.frame.numRays);
    CHECK(speed.traversal.numHits == speed.frame.numHits);
    CHECK(speed.hits.numHits == speed.frame.numHits);
}

TEST_CASE("Rates are of the shortest times, and their spread is of single repetitions", "[speed]")
{
    const std::vector<bench::Comparison> rows = bench::compare("monkey", "student", speedOf(1000));
    REQUIRE(rows.size() == 5);
    CHECK(rows[0].scene == "monkey");
    CHECK(rows[0].ourRate == Approx(6.0));
    CHECK(rows[0].theirRate == Approx(12.0));
    CHECK(rows[0].ratio == Approx(0.5));
    CHECK(rows[0].leastRatio == Approx(0.2));
    CHECK(rows[0].mostRatio == Approx(1.0));
    CHECK(rows[2].theirs == "student's frame");
    CHECK(rows[2].ratio == Approx(6.0 / 0.75)); // theirs sends half as many rays
    CHECK(rows[4].ours == "2 threads");
    CHECK(rows[4].ratio == Approx(2.0));
    CHECK(bench::toJson(rows).size() == rows.size());
}

TEST_CASE("Only where there are many triangles must the library be ten times as fast", "[speed]")
{
    CHECK_FALSE(bench::compare("a", "b", speedOf(14'999))[2].goal);
    CHECK(bench::compare("a", "b", speedOf(15'000))[2].goal == 10.0);
}
