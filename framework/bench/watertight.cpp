#include "bench/watertight.h"
#include "app/run_command.h"
#include "bench/closed_mesh.h"
#include "bench/rival.h"
#include "sampler.h"
#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <map>

namespace bench {
namespace {

    constexpr float scales[] = { 1e-3f, 1.0f, 1e3f };
    constexpr float distances[] = { 0.0f, 1.0f, 1e3f, 1e6f }; // from the origin, in units of the mesh
    constexpr std::size_t numMeshes = std::size(scales) * std::size(distances);
    constexpr std::size_t chunkSize = 1 << 16;

    struct Leaks {
        std::size_t corners = 0, edges = 0;
    };

    glm::vec3 random(Sampler& sampler)
    {
        const glm::vec2 xy = sampler.next_2d();
        return 2.0f * glm::vec3(xy, sampler.next_1d()) - 1.0f;
    }

    // Every other ray at a corner, the others at a point between two.
    std::vector<Ray> makeRays(const ClosedMesh& mesh, float scale, const glm::vec3& middle, Sampler& sampler)
    {
        std::vector<Ray> rays;
        for (std::size_t i = 0; i < chunkSize; ++i) {
            const auto which = static_cast<std::size_t>(sampler.next_1d() * static_cast<float>(mesh.triangles.size()));
            const auto& [a, b, c] = mesh.triangles[which];
            const glm::vec3 target = i % 2 == 0 ? a : a + sampler.next_1d() * (b - a);
            const glm::vec3 origin = scale * (0.3f * random(sampler) + middle); // the mesh is nowhere nearer than that
            rays.push_back({ origin, target - origin });
        }
        return rays;
    }

    void countLeaks(Rival& rival, std::span<const Ray> rays, Leaks& leaks)
    {
        rival.load(rays);
        (void)rival.traceClosest();
        for (std::size_t i = 0; i < rays.size(); ++i)
            (i % 2 == 0 ? leaks.corners : leaks.edges) += !std::isfinite(rival.distance(i));
    }

    void measureLeaks(std::size_t numRays)
    {
        const std::size_t numChunks = numRays / (numMeshes * chunkSize) + 1;
        std::map<std::string, Leaks> leaks;
        Sampler sampler(1);
        for (const float scale : scales) {
            for (const float distance : distances) {
                const glm::vec3 middle = distance * glm::vec3(0.3f, -0.5f, 0.8f);
                ClosedMesh mesh(6);
                mesh.move(scale, middle);
                Rivals rivals;
                addWide(mesh.triangles, rivals);
                addEmbree(mesh.triangles, rivals);
                for (std::size_t chunk = 0; chunk < numChunks; ++chunk) {
                    const std::vector<Ray> rays = makeRays(mesh, scale, middle, sampler);
                    for (const auto& rival : rivals)
                        countLeaks(*rival, rays, leaks[rival->name]);
                }
            }
        }
        fmt::print("of {} rays from inside, so many left:\n", numChunks * numMeshes * chunkSize);
        for (const auto& [name, count] : leaks)
            fmt::print("{:<15} {:>9} at corners {:>9} at edges\n", name, count.corners, count.edges);
    }

}

Command declareWatertight(CLI::App& cli)
{
    const auto numRays = std::make_shared<std::size_t>(20'000'000);
    CLI::App& command
        = *cli.add_subcommand("watertight", "Rays at corners and edges of closed meshes: how many slip through");
    command.add_option("--rays", *numRays, "Rays")->capture_default_str()->check(CLI::PositiveNumber);
    const auto run = [numRays] {
        measureLeaks(*numRays);
        return app::Success;
    };
    return { &command, run };
}

}
