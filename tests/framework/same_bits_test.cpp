#include "accel/wide/tree.h"
#include "accel/wrapped_bvh.h"
#include "adaptive/render.h"
#include "app/render_pixels.h"
#include "files/scene_file.h"
#include "screen.h"
#include "world.h"
#include <catch2/catch.hpp>

using namespace tests;

namespace {

// The library's traversal by one of its instruction sets.
class KernelBVH : public accel::WrappedBVH {
public:
    KernelBVH(BVHInterface& bvh, const accel::wide::Kernel& kernel)
        : WrappedBVH(bvh)
        , m_tree(trianglesOf(bvh), kernel)
    {
    }

    bool intersect(RenderState& state, Ray& ray, HitInfo& hitInfo) const override
    {
        return intersectRayWithBVH(state, *this, ray, hitInfo);
    }
    [[nodiscard]] const accel::WideTree* wideTree() const override { return &m_tree; }

private:
    static std::vector<accel::WideTree::Triangle> trianglesOf(const BVHInterface& bvh)
    {
        std::vector<accel::WideTree::Triangle> triangles;
        for (const auto& [meshID, v0, v1, v2] : bvh.primitives())
            triangles.push_back({ v0.position, v1.position, v2.position });
        return triangles;
    }

    accel::WideTree m_tree;
};

}

TEST_CASE("Pictures are the same bit for bit with every instruction set that the processor has", "[render_image]")
{
    for (const std::string scene : { "cornell_box_parallelogram_light", "monkey", "transparency" }) {
        files::SceneFile file = files::loadSceneFile(RAYWORK_SCENES "/" + scene + ".toml");
        file.config.size = { 32, 32 };
        file.config.features.numPixelSamples = 4;
        file.config.features.enableReflections = file.config.features.enableShadows = true;
        World world(file.scene, file.config.features);
        const Trackball camera = makeTrackball(file.config);
        std::vector<std::vector<glm::vec3>> fixed;
        std::vector<std::vector<double>> adaptive;
        for (const accel::wide::Kernel* kernel : accel::wide::kernels()) {
            const KernelBVH bvh(world.bvh, *kernel);
            Screen screen(file.config.size);
            app::renderPixels(world.scene, bvh, world.features, camera, screen);
            fixed.push_back(screen.pixels());
            const adaptive::PixelRays rays(world.scene, bvh, world.features, camera, file.config.size, 0);
            adaptive.push_back(adaptive::render(rays, file.config.size, { .error = 0.05 }, [](float) {}).errors());
            CAPTURE(scene, kernel->name);
            CHECK(fixed.back() == fixed.front());
            CHECK(adaptive.back() == adaptive.front());
        }
    }
}
