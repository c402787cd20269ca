#include "accel/expected_rays.h"
#include "worker/library_bvh.h"
#include "world.h"
#include <catch2/catch.hpp>

using accel::ExpectedRays;
using accel::WideTree;

namespace {

Scene twoPanes()
{
    Scene scene;
    tests::addPane(scene, {}, 1.0f);
    tests::addPane(scene, {}, 2.0f);
    return scene;
}

// From the origin to the panes; every third leads away from them.
std::vector<Ray> raysOf(std::size_t number)
{
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < number; ++i)
        rays.push_back({ glm::vec3(0.0f), { 0.001f * static_cast<float>(i), 0.1f, i % 3 == 0 ? -1.0f : 1.0f } });
    return rays;
}

bool isSame(const std::optional<WideTree::Hit>& a, const std::optional<WideTree::Hit>& b)
{
    return a.has_value() == b.has_value()
        && (!a || (a->t == b->t && a->primitive == b->primitive && a->u == b->u && a->v == b->v));
}

}

TEST_CASE("Expected rays have the hits that each finds alone", "[expected]")
{
    const Scene scene = twoPanes();
    const worker::LibraryBVH bvh(scene, {});
    const WideTree& tree = *bvh.wideTree();
    const std::vector<Ray> rays = raysOf(ExpectedRays::most);
    ExpectedRays expected;
    expected.expect(rays);
    for (const Ray& ray : rays) {
        REQUIRE(expected.isNext(ray));
        CHECK(isSame(expected.takeNext(tree, bvh), tree.closest(ray)));
    }
    CHECK_FALSE(expected.isNext(rays.back()));
}

TEST_CASE("Expected rays are these, in this order, and no others", "[expected]")
{
    const Scene scene = twoPanes();
    const worker::LibraryBVH bvh(scene, {});
    const std::vector<Ray> rays = raysOf(ExpectedRays::most + 1);
    ExpectedRays expected;
    CHECK_FALSE(expected.isNext(rays[0]));
    expected.expect(rays);
    CHECK_FALSE(expected.isNext(rays[1]));
    Ray other = rays[0];
    other.t = 1.5f;
    CHECK_FALSE(expected.isNext(other));
    other = rays[0];
    other.direction.x = -0.0f; // equal, but not the same: a slope that is infinite the other way
    CHECK_FALSE(expected.isNext(other));
    for (std::size_t i = 0; i < ExpectedRays::most; ++i) {
        REQUIRE(expected.isNext(rays[i]));
        (void)expected.takeNext(*bvh.wideTree(), bvh);
    }
    CHECK_FALSE(expected.isNext(rays.back())); // one too many
}

TEST_CASE("Expected rays that are asked of another tree are traced in that one", "[expected]")
{
    const Scene scene = twoPanes(), empty;
    const worker::LibraryBVH panes(scene, {}), nothing(empty, {});
    const std::vector<Ray> rays = raysOf(6);
    ExpectedRays expected;
    expected.expect(rays);
    for (const Ray& ray : rays) {
        const worker::LibraryBVH& bvh = &ray - rays.data() < 3 ? panes : nothing;
        CHECK(isSame(expected.takeNext(*bvh.wideTree(), bvh), bvh.wideTree()->closest(ray)));
    }
}

TEST_CASE("An intersection that is expected is the same as one that is not", "[expected]")
{
    tests::World world(twoPanes());
    const worker::LibraryBVH bvh(world.scene, world.features);
    const std::vector<Ray> rays = raysOf(9);
    ExpectedRays expected;
    RenderState state { world.scene, world.features, bvh, Sampler(1) };
    for (const std::size_t skipped :
        { 9, 4, 0 }) { // the ray that nobody asks for: those behind it are asked for in vain
        expected.expect(rays);
        state.expected = &expected;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (i == skipped)
                continue;
            Ray a = rays[i], b = rays[i];
            HitInfo atA, atB;
            RenderState alone { world.scene, world.features, bvh, Sampler(1) };
            const bool isHit = bvh.intersect(state, a, atA);
            REQUIRE(isHit == bvh.intersect(alone, b, atB));
            CHECK(a.t == b.t);
            if (isHit)
                CHECK((atA.normal == atB.normal && atA.barycentricCoord == atB.barycentricCoord));
        }
    }
}
