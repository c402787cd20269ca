#include "bench/kernels.h"
#include "app/run_command.h"
#include "bench/ray_sets.h"
#include "intersect.h"
#include "sampler.h"
#include <benchmark/benchmark.h>
#include <map>

namespace bench {
namespace {

    using accel::WideTree;
    using accel::wide::Kernel;
    using benchmark::State;

    constexpr std::size_t numRays = 1 << 14;

    glm::vec3 randomPoint(Sampler& sampler)
    {
        const glm::vec2 xy = sampler.next_2d();
        return 2.0f * glm::vec3(xy, sampler.next_1d()) - 1.0f;
    }

    // From about the unit cube into it.
    std::vector<Ray> randomRays()
    {
        Sampler sampler(1);
        std::vector<Ray> rays;
        for (std::size_t i = 0; i < numRays; ++i) {
            const glm::vec3 origin = 2.0f * randomPoint(sampler);
            rays.push_back({ origin, glm::normalize(randomPoint(sampler) - origin) });
        }
        return rays;
    }

    // Small ones around a point.
    void addTriangles(const glm::vec3& middle, std::size_t number, Sampler& sampler, std::vector<Triangle>& triangles)
    {
        const auto corner = [&] { return middle + 0.2f * randomPoint(sampler); };
        for (std::size_t i = 0; i < number; ++i)
            triangles.push_back({ corner(), corner(), corner() });
    }

    struct Fixture {
        WideTree tree;
        std::vector<Ray> rays;
    };

    // All its tree is a block, which every ray is tested against.
    const Fixture& oneBlock()
    {
        static const Fixture fixture = [] {
            Sampler sampler(1);
            std::vector<Triangle> triangles;
            addTriangles(glm::vec3(0.0f), accel::wide::width, sampler, triangles);
            return Fixture { WideTree(triangles), randomRays() };
        }();
        return fixture;
    }

    // Clusters in the corners of a cube; the rays go through its middle and enter no box of the root.
    const Fixture& oneNode()
    {
        static const Fixture fixture = [] {
            Sampler sampler(1);
            std::vector<Triangle> triangles;
            for (const float x : { -1.0f, 1.0f })
                for (const float y : { -1.0f, 1.0f })
                    for (const float z : { -1.0f, 1.0f })
                        addTriangles({ x, y, z }, 64, sampler, triangles);
            std::vector<Ray> rays;
            for (std::size_t i = 0; i < numRays; ++i)
                rays.push_back({ { 0.2f * randomPoint(sampler) }, glm::normalize(glm::vec3(1, 0.1f, 0.1f)) });
            return Fixture { WideTree(triangles), std::move(rays) };
        }();
        return fixture;
    }

    const Model& dragon()
    {
        static const Model model = loadModel("dragon");
        return model;
    }

    // The rays of this name.
    const Fixture& dragonWith(std::string_view name)
    {
        static const std::map<std::string_view, Fixture> fixtures = [] {
            std::map<std::string_view, Fixture> made;
            for (RaySet& set : makeRaySets(dragon(), WideTree(dragon().triangles), numRays))
                made.emplace(set.name, Fixture { WideTree(dragon().triangles), std::move(set.rays) });
            return made;
        }();
        return fixtures.at(name);
    }

    // Calls ask with one ray after the other, again and again.
    template <typename Ask> void forEachRay(State& state, std::span<const Ray> rays, const Ask& ask)
    {
        std::size_t i = 0;
        for ([[maybe_unused]] auto _ : state) {
            benchmark::DoNotOptimize(ask(rays[i]));
            i = i + 1 == rays.size() ? 0 : i + 1;
        }
    }

    // What one ray is tested against, on average: whether the numbers are what their name says.
    void count(State& state, const Fixture& fixture, bool isClosest)
    {
        accel::wide::Counters counters;
        for (const Ray& ray : fixture.rays) {
            if (isClosest)
                benchmark::DoNotOptimize(fixture.tree.closest(ray, counters));
            else
                benchmark::DoNotOptimize(fixture.tree.occluded(ray, counters));
        }
        const auto perRay
            = [&](uint64_t number) { return static_cast<double>(number) / static_cast<double>(fixture.rays.size()); };
        state.counters["nodes"] = perRay(counters.nodes);
        state.counters["blocks"] = perRay(counters.blocks);
    }

    using FixtureOnDemand = const Fixture& (*)();

    void addTraversal(const std::string& name, FixtureOnDemand fixtureOf, bool isClosest = true)
    {
        for (const Kernel* kernel : accel::wide::kernels())
            benchmark::RegisterBenchmark((name + "/" + kernel->name).c_str(), [=](State& state) {
                const Fixture& fixture = fixtureOf();
                if (isClosest)
                    forEachRay(state, fixture.rays, [&](const Ray& ray) { return fixture.tree.closest(ray, *kernel); });
                else
                    forEachRay(
                        state, fixture.rays, [&](const Ray& ray) { return fixture.tree.occluded(ray, *kernel); });
                count(state, fixture, isClosest);
            });
    }

    // meets: a ray by reference, which it may shorten.
    template <typename Meets> void addShape(const char* name, const Meets& meets)
    {
        benchmark::RegisterBenchmark(name, [=](State& state) {
            HitInfo hitInfo;
            forEachRay(state, randomRays(), [&](Ray ray) { return meets(ray, hitInfo); });
        });
    }

    void addAll()
    {
        addTraversal("one_node", oneNode);
        addTraversal("one_block", oneBlock);
        addTraversal("dragon/primary/closest", []() -> const Fixture& { return dragonWith("primary"); });
        addTraversal("dragon/diffuse/closest", []() -> const Fixture& { return dragonWith("diffuse"); });
        addTraversal(
            "dragon/shadow/any", []() -> const Fixture& { return dragonWith("shadow"); }, false);
        benchmark::RegisterBenchmark("dragon/build",
            [](State& state) {
                for ([[maybe_unused]] auto _ : state)
                    benchmark::DoNotOptimize(WideTree(dragon().triangles));
            })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();

        addShape("intersectRayWithTriangle", [](Ray& ray, HitInfo& hitInfo) {
            return intersectRayWithTriangle({ -1, -1, 0 }, { 1, -1, 0 }, { 0, 1, 0 }, ray, hitInfo);
        });
        addShape("intersectRayWithShape/sphere",
            [sphere = Sphere {}](Ray& ray, HitInfo& hitInfo) { return intersectRayWithShape(sphere, ray, hitInfo); });
        addShape("intersectRayWithShape/box",
            [box = AxisAlignedBox { glm::vec3(-0.5f), glm::vec3(0.5f) }](
                Ray& ray, HitInfo&) { return intersectRayWithShape(box, ray); });
    }

    int run(std::vector<std::string> arguments)
    {
        std::string name = "./raywork bench kernels";
        std::vector<char*> words { name.data() };
        for (std::string& argument : arguments)
            words.push_back(argument.data());
        auto count = static_cast<int>(words.size());
        addAll();
        benchmark::Initialize(&count, words.data());
        if (benchmark::ReportUnrecognizedArguments(count, words.data()))
            return app::BadInput;
        benchmark::RunSpecifiedBenchmarks();
        return app::Success;
    }

}

Command declareKernels(CLI::App& cli)
{
    CLI::App& command = *cli.add_subcommand("kernels", "Single functions, by Google Benchmark, with its flags");
    command.prefix_command(); // which it reads by itself, --help among them
    command.set_help_flag();
    return { &command, [&command] { return run(command.remaining()); } };
}

}
