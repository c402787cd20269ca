#include "accel/wide/tree.h"
#include "bench/closed_mesh.h"
#include "random_triangles.h"
#include <catch2/catch.hpp>

using accel::WideTree;
using grading::Random;

namespace {

// Every ray of a beam finds, with each kernel, what it finds alone.
void checkBeam(const WideTree& tree, const std::vector<Ray>& rays)
{
    for (const accel::wide::Kernel* kernel : accel::wide::kernels()) {
        CAPTURE(kernel->name);
        std::vector<std::optional<WideTree::Hit>> hits(rays.size());
        tree.closest(rays, hits, *kernel);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            CAPTURE(i, rays.size());
            const auto alone = tree.closest(rays[i]);
            REQUIRE(hits[i].has_value() == alone.has_value());
            if (alone)
                REQUIRE((hits[i]->t == alone->t && hits[i]->primitive == alone->primitive && hits[i]->u == alone->u
                    && hits[i]->v == alone->v));
        }
    }
}

// From one point to about another.
std::vector<Ray> beamTo(const glm::vec3& target, const glm::vec3& origin, float spread, Random& random)
{
    std::vector<Ray> rays(static_cast<std::size_t>(random.integer(1, 64)));
    for (Ray& ray : rays)
        ray = { origin, target + spread * random.vec3(-1.0f, 1.0f) - origin };
    return rays;
}

}

TEST_CASE("Beam, narrow or wide, finds what each of its rays finds alone", "[wide]")
{
    Random random(1, "beam");
    for (const int count : { 1, 41, 300, 3000, 30000 }) {
        for (const float size : { 0.02f, 0.3f }) {
            const WideTree tree(tests::randomTriangles(random, count, size));
            for (const float spread : { 0.0f, 0.001f, 0.03f, 0.3f, 3.0f }) {
                CAPTURE(count, size, spread);
                for (int i = 0; i < 40; ++i)
                    checkBeam(tree, beamTo(random.vec3(-1.0f, 1.0f), random.vec3(-2.0f, 2.0f), spread, random));
            }
        }
    }
}

TEST_CASE("Beam, each ray ends where it ends", "[wide]")
{
    Random random(1, "ends");
    const WideTree tree(tests::randomTriangles(random, 3000, 0.3f));
    for (int i = 0; i < 200; ++i) {
        std::vector<Ray> rays = beamTo(random.vec3(-1.0f, 1.0f), random.vec3(-2.0f, 2.0f), 0.1f, random);
        for (Ray& ray : rays) {
            const auto hit = tree.closest(ray);
            const float t = hit ? hit->t : 1.0f;
            ray.t = std::array { t, std::nextafter(t, -1.0f), 0.5f * t, -1.0f, std::nanf("") }[random.integer(0, 4)];
        }
        checkBeam(tree, rays);
    }
}

TEST_CASE("Beam, what its rays share may be anything, or nothing", "[wide]")
{
    Random random(1, "odd");
    const WideTree few(tests::randomTriangles(random, 30, 0.3f)), many(tests::randomTriangles(random, 3000, 0.3f));
    const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
    for (int i = 0; i < 500; ++i) {
        std::vector<Ray> rays = beamTo(random.vec3(-1.0f, 1.0f), random.vec3(-2.0f, 2.0f), 0.1f, random);
        for (Ray& ray : rays) // along axes, across octants, from elsewhere, to nowhere
            if (random.integer(0, 3) == 0)
                ray.direction[random.integer(0, 2)] = std::array { 0.0f, -0.0f, 1e-40f, nan, infinity }[i % 5];
        if (i % 7 == 0)
            rays.front().origin = random.vec3(-2.0f, 2.0f);
        checkBeam(few, rays);
        checkBeam(many, rays);
    }
}

TEST_CASE("Beam, none of its rays leaves a closed mesh, through corners and edges neither", "[wide]")
{
    Random random(1, "watertight beam");
    for (const float distance : { 0.0f, 1.0f, 1e3f, 1e6f }) {
        CAPTURE(distance);
        const glm::vec3 middle = distance * glm::vec3(0.3f, -0.5f, 0.8f);
        bench::ClosedMesh mesh(5);
        mesh.move(1.0f, middle);
        const WideTree tree(mesh.triangles);
        for (std::size_t first = 0; first + 16 <= mesh.triangles.size(); first += 16) { // neighbours
            const glm::vec3 inside = middle + 0.3f * random.vec3(-1.0f, 1.0f);
            std::vector<Ray> rays;
            for (std::size_t i = first; i < first + 16; ++i)
                for (const float s : { 0.0f, random.uniform() })
                    rays.push_back({ inside, glm::mix(mesh.triangles[i][0], mesh.triangles[i][1], s) - inside });
            checkBeam(tree, rays);
        }
    }
}
