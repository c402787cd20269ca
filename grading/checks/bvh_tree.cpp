#include "bvh.h"
#include "grading/check.h"
#include "grading/checks/bvh_rays.h"
#include "grading/expect.h"
#include "grading/picture.h"
#include "shapes/shapes.h"
#include "worker/scene_message.h"
#include <fmt/format.h>

// Whether the traversal goes by the boxes.
namespace grading::bvh_tree {
namespace {

    // From beside two heaps, so that no ray starts in a box, into one of them.
    Ray rayIntoHeap(Random& random, const glm::vec3& heap)
    {
        for (;;) {
            const Ray ray = rayFromOutside(random);
            if (std::max(std::abs(ray.origin.y), std::abs(ray.origin.z)) > 2.0f)
                return { heap + ray.origin, ray.direction };
        }
    }

    // Two heaps of triangles so far apart that every tree tells them apart. When all boxes of one are moved away, what
    // is left is the other.
    const Check used("bvh.tree.used", 1.0,
        "a box that the ray misses rules out all that is in it: do not try triangles of nodes whose box was not hit",
        [](Exam& exam) {
            const glm::vec3 offset { 5.0f, 0.0f, 0.0f };
            Scene left, both;
            addTriangles(left, exam.random, 100, -offset);
            both = left;
            addTriangles(both, exam.random, 100, offset);
            std::vector<Ray> rays;
            for (int i = 0; i < 300; ++i) {
                const Ray ray = rayIntoHeap(exam.random, i % 2 == 0 ? offset : -offset);
                if (closestHit(left, ray).isClear && closestHit(both, ray).isClear)
                    rays.push_back(ray);
            }
            const AxisAlignedBox right { offset - 2.0f, offset + 2.0f };
            const std::vector<Traversal> came = traverse(exam, both, withTree, rays, right);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const SceneHit expected = closestHit(left, rays[i]);
                const bool found = came[i].isHit && !expected.isHit;
                expect(!found, TracedRay { both, rays[i], came[i], expected }.asked(),
                    fmt::format("a triangle at t = {:.6g}", came[i].t), "no hit: the boxes around it were moved away");
                expectClosest({ both, rays[i], came[i], expected });
            }
        });

    Scene dragon()
    {
        Scene scene;
        scene.meshes.push_back(shapes::makeShape("dragon").value());
        return scene;
    }

    std::vector<Ray> raysFromOutside(Random& random, int count)
    {
        std::vector<Ray> rays;
        for (int i = 0; i < count; ++i)
            rays.push_back(rayFromOutside(random));
        return rays;
    }

    // So many rays among so many triangles that trying all of them takes longer than anybody waits. The expected hits
    // are those of the library's own traversal, which tests hold against all triangles.
    const Check large("bvh.tree.large", 1.0,
        "a ray visits a few dozen of the tree's boxes: no copies of nodes or triangles, nothing tried twice",
        [](Exam& exam) {
            const Scene scene = dragon();
            const std::vector<Ray> rays = raysFromOutside(exam.random, 40'000);
            const std::vector<Traversal> came = traverse(exam, scene, withTree, rays);
            const BVH bvh(scene, withTree);
            RenderState state { scene, withTree, bvh, Sampler(1) };
            std::size_t numWrong = 0;
            for (std::size_t i = 0; i < rays.size(); ++i) {
                Ray ray = rays[i];
                HitInfo unused;
                const bool isHit = intersectRayWithBVH(state, bvh, ray, unused);
                const double difference = std::abs(static_cast<double>(ray.t) - static_cast<double>(came[i].t));
                numWrong += !(isHit == came[i].isHit && (!isHit || difference <= distanceTolerance));
            }
            // An outline is met or missed by rounding: there lies less than a ray in ten thousand. Ten times
            // that passes.
            expect(numWrong <= rays.size() / 1000,
                fmt::format("BVH::intersect for {} rays at a shape of {} triangles", rays.size(),
                    scene.meshes[0].triangles.size()),
                fmt::format("{} wrong answers", numWrong), "next to none");
        });

    const Check off("bvh.tree.off", 0.5, "without enableAccelStructure the result is the same", [](Exam& exam) {
        Scene scene;
        addTriangles(scene, exam.random, 200);
        const std::vector<Ray> rays = clearRays(exam.random, scene, 400, rayFromOutside);
        (void)traverse(exam, scene, withTree, rays); // whoever has not written it gets no points for brute force
        compare(exam, scene, Features {}, rays, expectClosest);
    });

    const Check picture("bvh.picture.dragon", 1.0, "see the checks of BVH::intersect",
        [](Exam& exam) { comparePicture(exam, pictureOf("dragon")); });

}
}
